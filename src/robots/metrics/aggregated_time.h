#pragma once

#include <vector>

#include "social_crowd/robot_result.h"

namespace crowd {

/// @brief Writes the aggregated time of all robots of an episode: when the last robot with goals and the last person
/// had arrived (Francis et al. 2025, AT); NaN if not all have, or nobody was to arrive.
/// @param people_time when the last person arrived [s]; 0 without people, NaN if not all have
inline void writeAggregatedTime(double people_time, std::vector<RobotResult>& robots) {
  double time = people_time;
  for (const RobotResult& robot : robots) {
    if (robot.timeout) time = RobotResult::NONE;
    if (robot.success && robot.time_to_reach_goal > time) time = robot.time_to_reach_goal;
  }
  for (RobotResult& robot : robots) robot.aggregated_time = time > 0.0 ? time : RobotResult::NONE;
}

}  // namespace crowd
