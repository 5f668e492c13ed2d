#pragma once

#include <cstdint>
#include <string>

#include "simulation/episode_result.h"

namespace crowd {

/// @brief Header of a record of robots: `episode,scenario`, then the fields of RobotResult, in their order and units;
/// those that are true or false are 1 or 0.
std::string robotRecordHeader();

/// @brief Appends a row for each robot of an episode.
void appendRobotRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows);

/// @brief Header of a record of the goals of robots: `episode,scenario,robot,goal`, then the fields of RobotGoalResult.
std::string robotGoalHeader();

/// @brief Appends a row for each goal of each robot of an episode.
void appendRobotGoalRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows);

/// @brief Sums up the robots of many episodes in one line, such as "robots: 20 of 20 arrived, 18 clean, ..."; empty if
/// there were none.
class RobotSummary {
 public:
  void add(const EpisodeResult& result);
  std::string text() const;

 private:
  std::uint64_t robots_ = 0;
  std::uint64_t arrived_ = 0;
  std::uint64_t clean_ = 0;
  std::uint64_t on_person_ = 0;
  std::uint64_t on_robot_ = 0;
  std::uint64_t mutual_ = 0;
  double time_ = 0.0;           // of those that arrived [s]
  std::uint64_t people_ = 0;    // whose delay was measured
  double people_delay_ = 0.0;   // sum [s]
  double people_detour_ = 0.0;  // sum [m]
};

}  // namespace crowd
