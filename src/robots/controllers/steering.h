#pragma once

#include "geometry/drive.h"

namespace crowd {

/// @brief Distance from its goal below which a robot drives more slowly [m].
inline constexpr double SLOW_DOWN_DISTANCE = 1.0;

/// @brief The command of a robot that is to move in a direction.
///
/// HOLONOMIC: the velocity in that direction, without a rotation. DIFFERENTIAL: it turns at 2 rad/s per rad of the
/// bearing, and drives at speed * cos(bearing) while the bearing is below 30 degrees; else it turns on the spot.
/// ACKERMANN: it turns alike, and drives at speed * cos(bearing), but at no less than a fifth of the speed, as it
/// cannot turn on the spot. The limits of the drive apply to the command as to any other.
/// @param bearing of the direction in the robot's frame [rad] @param speed [m/s]
Twist steer(Drive drive, double bearing, double speed);

}  // namespace crowd
