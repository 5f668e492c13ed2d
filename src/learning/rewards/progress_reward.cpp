#include "learning/rewards/progress_reward.h"

#include <algorithm>
#include <cmath>

#include "avoidance/time_to_collision.h"
#include "common/text/numbers.h"

namespace crowd {
namespace {

/// Upper bound of the relative rounding errors of squares and roots.
constexpr double PROGRESS_ROUNDING = 1e-12;

bool touchesAny(const NeighbourSpan& neighbours, double radius) {
  const double* const xs = neighbours.xs();
  const double* const ys = neighbours.ys();
  const double* const radii = neighbours.radii();
  const std::size_t count = neighbours.size();
  const auto square = [&](std::size_t i) { return xs[i] * xs[i] + ys[i] * ys[i]; };
  // Contacts are rare: squares tell first whether there can be any, as roots take most of the time.
  bool may_touch = false;
  for (std::size_t i = 0; i < count; ++i) {
    const double reach = radius + radii[i];
    may_touch |= square(i) <= reach * reach * (1.0 + PROGRESS_ROUNDING);
  }
  for (std::size_t i = 0; may_touch && i < count; ++i) {
    if (std::sqrt(square(i)) < radius + radii[i]) return true;
  }
  return false;
}

}  // namespace

double ProgressReward::conflictPart(const Perception& after) const {
  const double time = timeToCollision(after, after.self.velocity);
  const bool arrives_first = time > after.self.goal.norm() / after.self.max_speed;
  if (arrives_first) return 0.0;
  return -parameters_.conflict_penalty * std::max(0.0, 1.0 - time / parameters_.conflict_time);
}

double ProgressReward::operator()(const AgentPerception& before, const Perception& after, Row /*row*/) const {
  const AgentPerception& self = after.self;
  const double progress = distanceGained(before, self) / (self.max_speed * after.tick_duration);
  const double turn = std::abs(wrapAngle(self.pose.heading - before.pose.heading));
  const double rest = 1.0 - self.velocity.norm() / self.max_speed;
  double reward = progress - 1.0 - parameters_.turn_penalty * turn - parameters_.rest_penalty * rest;
  if (touchesAny(after.neighbours, self.radius)) reward -= parameters_.contact_penalty;
  return self.arrived ? reward : reward + conflictPart(after);
}

std::string ProgressReward::spec() const {
  return std::string("{type: ") + TYPE + ", turn_penalty: " + toText(parameters_.turn_penalty) +
         ", conflict_penalty: " + toText(parameters_.conflict_penalty) +
         ", conflict_time: " + toText(parameters_.conflict_time) +
         ", rest_penalty: " + toText(parameters_.rest_penalty) +
         ", contact_penalty: " + toText(parameters_.contact_penalty) + "}";
}

std::shared_ptr<const Reward> readProgressReward(YamlMap& map, const StateSet& /*state_set*/) {
  map.allow({"type", "turn_penalty", "conflict_penalty", "conflict_time", "rest_penalty", "contact_penalty"});
  ProgressReward::Parameters parameters;
  const auto read_penalty = [&](const char* key, double& penalty) {
    penalty = map.number(key, NumberRule::NOT_NEGATIVE, penalty);
  };
  read_penalty("turn_penalty", parameters.turn_penalty);
  read_penalty("conflict_penalty", parameters.conflict_penalty);
  parameters.conflict_time = map.number("conflict_time", NumberRule::POSITIVE, parameters.conflict_time);
  read_penalty("rest_penalty", parameters.rest_penalty);
  read_penalty("contact_penalty", parameters.contact_penalty);
  return std::make_shared<ProgressReward>(parameters);
}

}  // namespace crowd
