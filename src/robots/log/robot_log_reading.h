#pragma once

#include <functional>
#include <string>

#include "common/files/files.h"
#include "robots/log/robot_log.h"

namespace crowd {

/// @brief Reads a log of robots (docs/metrics.md, "Logs") and calls a function for each header, and for each tick
/// behind it.
/// @throws FileError; InputError "FILE: line N: PATH: expected ..., got ..." if a line is not an object of JSON, a key
/// or a value is wrong, ticks are not one after the other, or their robots are not those of the header; whatever the
/// functions throw
void readRobotLog(const std::string& file, const std::function<void(RobotLogHeader&)>& begin,
                  const std::function<void(RobotLogTick&)>& add, FileKinds kinds = FileKinds::REGULAR);

}  // namespace crowd
