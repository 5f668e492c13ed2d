#pragma once

#include <cstdint>

#include "ros/controller/answer_collector.h"
#include "simulation/evaluation/metrics.h"
#include "simulation/evaluation/robot_record.h"

namespace crowd {

/// @brief What the crowd controller logs of the results of its episodes.
class ResultLog {
 public:
  /// @brief Logs an episode that is over. @param instance since the scenario was loaded or reset
  void add(const EpisodeResult& result, std::uint64_t episode, std::uint64_t instance, const AnswerCollector& answers);
  /// @brief Logs all episodes together, if they are several.
  void logAll() const;

 private:
  Metrics metrics_;
  RobotSummary robots_;
};

/// @brief Logs what is wrong with the ways of an episode, if anything is.
void warnOfWays(const EpisodeResult& result, std::uint64_t episode, const char* when);

}  // namespace crowd
