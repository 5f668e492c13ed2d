#include <algorithm>
#include <cmath>

#include "avoidance/time_to_collision.h"
#include "common/text/numbers.h"
#include "learning/rewards/reward.h"

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

/// Progress towards the goal, less the time that has passed, less penalties on turning, collision courses,
/// standing still and contact. Unit: ticks; progress is the decrease of the distance to the goal divided by the path of
/// one tick at maximum speed. A tick straight to the goal at full speed without a collision course has the reward 0.
/// Source: docs/state_sets.md.
class ProgressReward : public Reward {
 public:
  static constexpr const char* TYPE = "progress";
  static std::shared_ptr<const Reward> read(YamlMap& map, const StateSet& state_set);

  struct Parameters {
    double turn_penalty = 0.6;      ///< per angle that the heading turns [ticks/rad]
    double conflict_penalty = 1.0;  ///< of a collision course, if contact is immediate; decreases linearly to 0 [ticks]
    double conflict_time = 4.0;     ///< time to contact from which there is no penalty [s]
    double rest_penalty = 0.5;      ///< of standing still; decreases linearly to 0 at maximum speed [ticks]
    double contact_penalty = 20.0;  ///< of an overlap with a neighbour, whatever their number [ticks]
  };

  explicit ProgressReward(const Parameters& parameters) : parameters_(parameters) {}

  double operator()(const AgentPerception& before, const Perception& after, Row row) const override;
  std::string spec() const override;

 private:
  double conflictPart(const Perception& after) const;

  Parameters parameters_;
};

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

std::shared_ptr<const Reward> ProgressReward::read(YamlMap& map, const StateSet& /*state_set*/) {
  map.allow({"type", "turn_penalty", "conflict_penalty", "conflict_time", "rest_penalty", "contact_penalty"});
  Parameters parameters;
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

}  // namespace

RewardType progressReward() {
  return {ProgressReward::TYPE, "progress in ticks, less penalties on turning, collision courses, standing and contact",
          ProgressReward::read};
}

}  // namespace crowd
