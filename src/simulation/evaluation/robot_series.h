#pragma once

#include <cstdint>
#include <string>

#include "robots/robot_monitor.h"

namespace crowd {

/// @brief Header of a time series of robots: `instance,tick,time,robot`, then the columns of RobotSample.
std::string robotSeriesHeader();

/// @brief Appends a row for each robot that was measured in the last tick, or at the start.
/// @param time since the start [s]
void appendRobotSeries(std::uint64_t instance, std::uint64_t tick, double time, const RobotMonitor& monitor,
                       std::string& rows);

}  // namespace crowd
