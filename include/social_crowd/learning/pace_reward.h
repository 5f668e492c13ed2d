#pragma once

#include "social_crowd/learning/reward.h"

namespace crowd {

/// @brief What a tick cost, measured in ticks: progress made less the tick itself, less prices on turning, on a course
/// to contact, on standing about and on contact. A tick straight to the goal at full speed, nobody in the way, is worth
/// 0.
class PaceReward : public Reward {
 public:
  static constexpr const char* TYPE = "pace";

  struct Parameters {
    double turn_price = 0.6;      ///< of a turn of the heading [1/rad]
    double conflict_price = 1.0;  ///< of a course to contact; in full if that is at hand, less the later it comes
    double conflict_time = 4.0;   ///< a contact that far ahead costs nothing [s]
    double rest_price = 0.5;      ///< of standing still, less the faster the agent went
    double contact_price = 20.0;  ///< of overlapping a body
  };

  PaceReward() : PaceReward(Parameters()) {}
  explicit PaceReward(const Parameters& parameters) : parameters_(parameters) {}

  double operator()(const AgentPerception& before, const Perception& after, Row row) const override;
  std::string spec() const override;

 private:
  double conflictPart(const Perception& after) const;

  Parameters parameters_;
};

/// @brief Reads a map of the parameters, all optional. @throws InputError
std::shared_ptr<const Reward> readPaceReward(YamlMap& map);

}  // namespace crowd
