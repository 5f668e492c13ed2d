#pragma once

#include <string>

#include "simulation/episode_result.h"
#include "simulation/evaluation/metrics.h"

namespace crowd {

/// @brief Header of the CSV file of metrics; csvRow() makes its rows.
constexpr const char* METRICS_CSV_HEADER =
    "scenario,instances,success_pct,contact_pct,collision_pct,clean_pct,path_ratio,time_ratio,turn_rad_per_m,max_speed_"
    "ratio,"
    "blocked_per_agent\n";

std::string csvRow(const std::string& name, const Metrics& metrics);

/// @brief Prints the header of the table of metrics, and the row of a scenario.
void printHeader();
void printRow(const std::string& name, const Metrics& metrics);

}  // namespace crowd
