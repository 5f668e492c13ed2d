#pragma once

#include <vector>

#include "scenario/robot.h"

namespace crowd {

/// @brief The command of a robot that knows its laser scan and the direction of its goal alone: it drives towards the
/// heading that leads nearest to the goal for the length that is free, no faster than it can stop within that length.
///
/// Headings are tested every 5 degrees. Their free length is that of the smallest disc that contains the footprint,
/// with a margin of 0.1 m. The robot does not predict motions and has no memory, so that dead ends trap it, and two
/// robots that meet head-on may stand in front of each other.
/// @param goal in the robot's frame [m] @param ranges of the robot's scanner, as ScanSpec describes it (REP 117): +inf
/// and NaN are nothing, -inf is something at the least range
Twist reactiveCommand(const RobotStart& robot, const Vector2& goal, const std::vector<float>& ranges);

}  // namespace crowd
