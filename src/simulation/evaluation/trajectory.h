#pragma once

#include <cstdint>
#include <string>

#include "common/files/growing_file.h"
#include "world/world.h"

namespace crowd {

/// @brief Header of a trajectory file. Each row holds the position of an agent's centre [m, `map`] at the end of a
/// tick; tick 0 is the start. The last row of an agent is the tick of its arrival.
constexpr const char* TRAJECTORY_HEADER = "instance,tick,agent,x,y\n";

/// @brief Appends the rows of the present tick: one for each agent that is on its way or has just arrived.
void appendTrajectoryRows(std::uint64_t instance, const World& world, std::string& rows);

/// @brief Whether an agent has a row in the present tick.
bool hasTrajectoryRow(const Agent& agent, const World& world);

/// @brief Appends the row of one agent. @param position [m], `map`
void appendTrajectoryRow(std::uint64_t instance, std::uint64_t tick, AgentId agent, const Vector2& position,
                         std::string& rows);

/// @brief Trajectory file to which episodes are appended.
class TrajectoryFile {
 public:
  /// @brief Creates or truncates FOLDER/NAME.csv, and creates the folder. @throws FileError
  TrajectoryFile(const std::string& folder, const std::string& name);
  /// @brief Appends the rows of an episode and flushes them to the operating system. @throws FileError
  void append(const std::string& rows) { file_.append(rows); }
  /// @brief Closes the file; once, at the end. @throws FileError
  void close() { file_.close(); }

 private:
  GrowingFile file_;
};

}  // namespace crowd
