#pragma once

#include "social_crowd/learning/rewards/reward.h"

namespace crowd {

/// @brief What a tick cost, measured in ticks: progress made less the tick itself, less penalties on turning, on a
/// collision course, on standing about and on contact. A tick straight to the goal at full speed, nobody in the way, is
/// worth 0.
class ProgressReward : public Reward {
 public:
  static constexpr const char* TYPE = "progress";

  struct Parameters {
    double turn_penalty = 0.6;      ///< of a turn of the heading [1/rad]
    double conflict_penalty = 1.0;  ///< of a collision course; in full if that is at hand, less the later it comes
    double conflict_time = 4.0;     ///< a contact that far ahead costs nothing [s]
    double rest_penalty = 0.5;      ///< of standing still, less the faster the agent went
    double contact_penalty = 20.0;  ///< of overlapping a body
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
std::shared_ptr<const Reward> readProgressReward(YamlMap& map);

}  // namespace crowd
