#pragma once

#include "learning/rewards/reward.h"

namespace crowd {

/// @brief Progress towards the goal, less the time that has passed, less penalties on turning, collision courses,
/// standing still and contact. Unit: ticks; progress is the decrease of the distance to the goal divided by the path of
/// one tick at maximum speed. A tick straight to the goal at full speed without a collision course has the reward 0.
/// Source: docs/state_sets.md.
class ProgressReward : public Reward {
 public:
  static constexpr const char* TYPE = "progress";

  struct Parameters {
    double turn_penalty = 0.6;      ///< per angle that the heading turns [ticks/rad]
    double conflict_penalty = 1.0;  ///< of a collision course, if contact is immediate; decreases linearly to 0 [ticks]
    double conflict_time = 4.0;     ///< time to contact from which there is no penalty [s]
    double rest_penalty = 0.5;      ///< of standing still; decreases linearly to 0 at maximum speed [ticks]
    double contact_penalty = 20.0;  ///< of an overlap with a neighbour, whatever their number [ticks]
  };

  ProgressReward() : ProgressReward(Parameters()) {}
  explicit ProgressReward(const Parameters& parameters) : parameters_(parameters) {}

  double operator()(const AgentPerception& before, const Perception& after, Row row) const override;
  std::string spec() const override;

 private:
  double conflictPart(const Perception& after) const;

  Parameters parameters_;
};

/// @brief Reads a map of the parameters, all optional. @throws InputError
std::shared_ptr<const Reward> readProgressReward(YamlMap& map, const StateSet& state_set);

}  // namespace crowd
