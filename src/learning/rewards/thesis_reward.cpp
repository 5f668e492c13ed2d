#include "social_crowd/learning/rewards/thesis_reward.h"

#include <array>
#include <cmath>

#include "social_crowd/common/numbers.h"
#include "social_crowd/learning/states/distance_classes.h"

namespace crowd {
namespace {

constexpr const char* DISTANCE_GAINED_NAME = "distance_gained";
constexpr const char* COSINE_CUBED_NAME = "cosine_cubed";
constexpr double FALL_PER_CLASS = 100.0;  // 10^2, (3.8) and (3.9)

/// What an obstacle of each distance class costs. An empty sector costs nothing: the printed (3.9), taken at D = 0,
/// would cost 1000.
std::array<double, DistanceClasses::COUNT + 1> costsByClass(double nearest) {
  std::array<double, DistanceClasses::COUNT + 1> costs{};
  for (std::size_t i = 1; i < costs.size(); ++i) costs[i] = nearest / std::pow(FALL_PER_CLASS, i - 1);
  return costs;
}

}  // namespace

ThesisReward::ThesisReward(const Parameters& parameters, const StateSet& state_set) : parameters_(parameters) {
  const auto costs = costsByClass(parameters.obstacle_cost);
  obstacle_parts_.reserve(state_set.rowCount());
  for (Row row = 0; row < state_set.rowCount(); ++row) {
    double sum = 0.0;
    for (const int distance_class : state_set.distanceClasses(row)) {
      sum -= costs.at(static_cast<std::size_t>(distance_class));
    }
    obstacle_parts_.push_back(sum);
  }
}

double ThesisReward::operator()(const AgentPerception& before, const Perception& after, Row row) const {
  const AgentPerception& self = after.self;
  if (self.arrived) return parameters_.arrival;
  const double worth = goalPart(before, self) + obstaclePart(row);
  return self.velocity.isZero(0.0) ? worth - parameters_.stay_cost : worth;
}

double ThesisReward::goalPart(const AgentPerception& before, const AgentPerception& after) const {
  if (parameters_.goal == GoalPart::DISTANCE_GAINED) return distanceGained(before, after);  // (3.6)
  // The goal is given in the agent's frame, so the angle to the new heading is that to the x axis.
  const double distance = after.goal.norm();
  const double cosine = distance > 0.0 ? after.goal.x() / distance : 1.0;
  return cosine * cosine * cosine;  // (3.7)
}

std::string ThesisReward::spec() const {
  return std::string("{goal: ") +
         (parameters_.goal == GoalPart::DISTANCE_GAINED ? DISTANCE_GAINED_NAME : COSINE_CUBED_NAME) +
         ", arrival: " + toText(parameters_.arrival) + ", obstacle_cost: " + toText(parameters_.obstacle_cost) +
         (parameters_.stay_cost > 0.0 ? ", stay_cost: " + toText(parameters_.stay_cost) : "") + "}";
}

std::shared_ptr<const Reward> readThesisReward(YamlMap& map, const StateSet& state_set) {
  map.allow({"type", "goal", "arrival", "obstacle_cost", "stay_cost"});
  ThesisReward::Parameters parameters;
  const std::string goal = map.text("goal");
  if (goal == DISTANCE_GAINED_NAME) {
    parameters.goal = ThesisReward::GoalPart::DISTANCE_GAINED;
  } else if (goal != COSINE_CUBED_NAME) {
    throwExpected(map.placeOf("goal"), map.need("goal"), "distance_gained or cosine_cubed");
  }
  parameters.arrival = map.number("arrival", NumberRule::ANY, parameters.arrival);
  parameters.obstacle_cost = map.number("obstacle_cost", NumberRule::NOT_NEGATIVE);
  parameters.stay_cost = map.number("stay_cost", NumberRule::NOT_NEGATIVE, parameters.stay_cost);
  return std::make_shared<ThesisReward>(parameters, state_set);
}

}  // namespace crowd
