#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "robots/log/robot_log.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief Writes an episode with robots as a log of robots (docs/metrics.md, "Logs"), from which score_robots computes
/// the same results, but those of commands and of people's delay.
class RobotLogRecord {
 public:
  /// @brief Appends the present tick of an episode. Call it once for each tick, from the start on. There is a header
  /// before the first tick with robots, and where robots came, left or got other goals. @param number of the episode
  void append(std::uint64_t number, const Episode& episode, std::string& text);

 private:
  RobotLogHeader headerOf(std::uint64_t number, const Episode& episode) const;
  RobotLogTick tickOf(const Episode& episode);
  LoggedPerson personOf(const Episode& episode, const ObservedPerson& observed);

  ObservedScene scene_;                      // scratch
  std::uint64_t headed_ = 0;                 // Robots::changes() of the last header; 0: there was none
  std::uint64_t layout_changes_ = 0;         // of the world, when walls were last written
  std::map<AgentId, LoggedPerson> written_;  // what was last written of the radius, the group and `endless`
};

}  // namespace crowd
