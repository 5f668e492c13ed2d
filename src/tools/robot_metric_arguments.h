#pragma once

#include <CLI/CLI.hpp>

#include "scenario/robot_metric_options.h"

namespace crowd {

/// @brief Adds the options of a tool that set what the metrics of robots depend on.
void addRobotMetricOptions(CLI::App& app, RobotMetricOptions& options);

}  // namespace crowd
