#pragma once

#include <functional>
#include <string>

#include "common/files/files.h"
#include "robots/log/robot_log_replay.h"

namespace crowd {

/// @brief Functions that scoreRobotLog() calls; empty ones are skipped.
struct LogScoring {
  std::function<void(const RobotLogReplay&)> on_tick;     ///< at the start, and after each tick
  std::function<void(const RobotLogReplay&)> on_episode;  ///< at the end of each episode
};

/// @brief Measures the robots of all episodes of a log.
/// @throws FileError, InputError as readRobotLog() and RobotLogReplay do, with the line; InputError if there is no
/// header, or an episode has no tick; whatever the functions throw
void scoreRobotLog(const std::string& file, const RobotMetricOptions& options, const LogScoring& scoring,
                   FileKinds kinds = FileKinds::REGULAR);

}  // namespace crowd
