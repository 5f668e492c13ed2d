#pragma once

#include <cstdint>
#include <string>

#include "social_crowd/common/files.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief First line of a trajectory file. A row says where an agent's centre [m, `map`] was at the end of a tick, tick
/// 0 being the start; its last row is the tick at which it arrived.
constexpr const char* TRAJECTORY_HEADER = "instance,tick,agent,x,y\n";

/// @brief Appends the rows of the world's present tick: one for each agent that is on its way or has just arrived.
void appendTrajectoryRows(std::uint64_t instance, const World& world, std::string& rows);

/// @brief A trajectory file that grows episode by episode.
class TrajectoryFile {
 public:
  /// @brief Begins FOLDER/NAME.csv anew; makes the folder. @throws FileError
  TrajectoryFile(const std::string& folder, const std::string& name);
  /// @brief Appends the rows of an episode and hands them to the system. @throws FileError
  void append(const std::string& rows) { file_.append(rows); }

 private:
  GrowingFile file_;
};

}  // namespace crowd
