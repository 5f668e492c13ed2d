#pragma once

#include <map>
#include <string>

#include "robots/log/robot_log.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief Writes an episode with robots as a log of robots (docs/metrics.md, "Logs"), from which score_robots computes
/// the same results, but those of commands and of people's delay.
class RobotLogRecord {
 public:
  /// @brief Appends the present tick of an episode; at its start also the header. Call it once for each tick.
  void append(const Episode& episode, std::string& text);

 private:
  RobotLogTick tickOf(const Episode& episode);
  LoggedPerson personOf(const Episode& episode, const ObservedPerson& observed);

  ObservedScene scene_;                      // scratch
  std::uint64_t layout_changes_ = 0;         // of the world, when walls were last written
  std::map<AgentId, LoggedPerson> written_;  // what was last written of the radius, the group and `endless`
};

}  // namespace crowd
