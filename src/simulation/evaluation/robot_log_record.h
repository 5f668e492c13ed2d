#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

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
  bool hasHeaderFor(const Robots& robots) const;
  RobotLogHeader headerOf(std::uint64_t number, const Episode& episode) const;
  RobotLogTick tickOf(const Episode& episode);
  LoggedPerson personOf(const Episode& episode, const ObservedPerson& observed);

  /// A robot as of the last header.
  struct Headed {
    RobotStart start;
    std::uint64_t goals_set = 0;
  };

  ObservedScene scene_;                      // scratch
  std::vector<Headed> headed_;               // robots of the last header
  std::uint64_t layout_changes_ = 0;         // of the world, when walls were last written
  std::map<AgentId, LoggedPerson> written_;  // what was last written of the radius, the group and `endless`
};

}  // namespace crowd
