#include <array>
#include <vector>

#include "common/text/enum_names.h"
#include "common/text/numbers.h"
#include "learning/rewards/reward.h"
#include "learning/states/distance_classes.h"
#include "learning/states/obstacle_classes.h"

namespace crowd {
namespace {

constexpr double FALL_PER_CLASS = 100.0;  // 10^2, (3.8) and (3.9)

/// Penalty of each distance class. That of an empty sector is 0, although the printed (3.9), taken at D = 0, gives
/// 1000.
std::array<double, DistanceClasses::COUNT + 1> penaltiesByClass(double nearest) {
  std::array<double, DistanceClasses::COUNT + 1> penalties{};
  double penalty = nearest;
  for (std::size_t i = 1; i < penalties.size(); ++i, penalty /= FALL_PER_CLASS) penalties[i] = penalty;
  return penalties;
}

/// The reward of the thesis: a constant on arrival, else a goal part plus an obstacle part (3.6-3.9), less a
/// penalty on staying. Without unit: as in the thesis, the parts are added as numbers, also with a goal part in metres.
/// The keys and members `obstacle_cost` and `stay_cost` are penalties.
class ThesisReward : public Reward {
 public:
  static constexpr const char* TYPE = "thesis";
  static std::shared_ptr<const Reward> read(YamlMap& map, const StateSet& state_set);

  enum class GoalPart {
    DISTANCE_GAINED,  ///< (3.6) decrease of the distance to the goal [m]
    COSINE_CUBED,     ///< (3.7) cos^3 of the angle between the new heading and the goal
  };
  static constexpr EnumNames<GoalPart, 2> GOAL_PARTS{"goal", {"distance_gained", "cosine_cubed"}};

  struct Parameters {
    GoalPart goal = GoalPart::COSINE_CUBED;
    double arrival = 100.0;  ///< reward on arrival, in place of all other parts
    /// Penalty on an obstacle of distance class 1; that on class D is this / 10^(2 (D-1)). (3.8): 80, for the nearest
    /// obstacle; (3.9): 10, summed over the occupied sectors.
    double obstacle_cost = 80.0;
    double stay_cost = 0.0;  ///< penalty on a tick in which the agent did not move (thesis 5.2)
  };

  /// Computes the obstacle part of every row of a state set.
  /// @param row_count number of rows of the state set
  ThesisReward(const Parameters& parameters, const RowDistanceClasses& state_set, Row row_count);

  double operator()(const AgentPerception& before, const Perception& after, Row row) const override;
  std::string spec() const override;

 private:
  double goalPart(const AgentPerception& before, const AgentPerception& after) const;

  Parameters parameters_;
  std::vector<double> obstacle_parts_;  // of each row, 0 or negative
};

ThesisReward::ThesisReward(const Parameters& parameters, const RowDistanceClasses& state_set, Row row_count)
    : parameters_(parameters) {
  const auto penalties = penaltiesByClass(parameters.obstacle_cost);
  obstacle_parts_.reserve(row_count);
  for (Row row = 0; row < row_count; ++row) {
    double sum = 0.0;
    for (const int distance_class : state_set.distanceClasses(row)) {
      sum -= penalties.at(static_cast<std::size_t>(distance_class));
    }
    obstacle_parts_.push_back(sum);
  }
}

double ThesisReward::operator()(const AgentPerception& before, const Perception& after, Row row) const {
  const AgentPerception& self = after.self;
  if (self.arrived) return parameters_.arrival;
  const double reward = goalPart(before, self) + obstacle_parts_[row];
  return self.velocity.isZero(0.0) ? reward - parameters_.stay_cost : reward;
}

double ThesisReward::goalPart(const AgentPerception& before, const AgentPerception& after) const {
  if (parameters_.goal == GoalPart::DISTANCE_GAINED) return distanceGained(before, after);  // (3.6)
  // The goal is in the agent's frame, so its angle to the new heading is that to the x axis.
  const double distance = after.goal.norm();
  const double cosine = distance > 0.0 ? after.goal.x() / distance : 1.0;
  return cosine * cosine * cosine;  // (3.7)
}

std::string ThesisReward::spec() const {
  return "{goal: " + GOAL_PARTS.nameOf(parameters_.goal) + ", arrival: " + toText(parameters_.arrival) +
         ", obstacle_cost: " + toText(parameters_.obstacle_cost) +
         (parameters_.stay_cost > 0.0 ? ", stay_cost: " + toText(parameters_.stay_cost) : "") + "}";
}

std::shared_ptr<const Reward> ThesisReward::read(YamlMap& map, const StateSet& state_set) {
  map.allow({"type", "goal", "arrival", "obstacle_cost", "stay_cost"});
  Parameters parameters;
  parameters.goal = GOAL_PARTS.need(map);
  parameters.arrival = map.number("arrival", NumberRule::ANY, parameters.arrival);
  parameters.obstacle_cost = map.number("obstacle_cost", NumberRule::NOT_NEGATIVE);
  parameters.stay_cost = map.number("stay_cost", NumberRule::NOT_NEGATIVE, parameters.stay_cost);
  const auto* const classes = dynamic_cast<const RowDistanceClasses*>(&state_set);
  if (classes == nullptr) {
    throwProblem(map.place(), map.node(),
                 "the reward of the thesis needs a state set whose rows encode distance classes; " + state_set.spec() +
                     " do not encode distance classes");
  }
  return std::make_shared<ThesisReward>(parameters, *classes, state_set.rowCount());
}

}  // namespace

RewardType thesisReward() {
  return {ThesisReward::TYPE, "the thesis's: arrival, approach of the goal, obstacles by distance class",
          ThesisReward::read};
}

}  // namespace crowd
