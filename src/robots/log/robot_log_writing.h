#pragma once

#include <string>

#include "robots/log/robot_log.h"

namespace crowd {

/// @brief Appends the line of a header, or of a tick, to a log of robots: an object of JSON. Numbers are read back as
/// the same ones, bit for bit.
void appendLogLine(const RobotLogHeader& header, std::string& text);
void appendLogLine(const RobotLogTick& tick, std::string& text);

}  // namespace crowd
