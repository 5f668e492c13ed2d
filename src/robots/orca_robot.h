#pragma once

#include <vector>

#include "robots/orca.h"
#include "robots/robot_perceiver.h"

namespace crowd {

/// @brief Drives a robot by optimal reciprocal collision avoidance (orca.h) along the way to its goal.
///
/// People take half of each evasion; walls and obstacles, which recorded people are for a robot, take nothing of it.
/// The wanted velocity leads to the next point of the way at the maximum speed, and slower in the last metre. The
/// velocity becomes a command by steer(). Acceleration and drive are not part of the method, so that a robot that is
/// not holonomic may touch people.
class OrcaRobot {
 public:
  static constexpr double HORIZON = 3.0;       ///< for people and obstacles that move [s]
  static constexpr double WALL_HORIZON = 1.0;  ///< [s]

  /// @param finds_ways see RobotPerceiver
  OrcaRobot(std::uint64_t episode, bool finds_ways) : perceiver_(episode, finds_ways) {}

  /// @brief The command of the coming tick; call it once a tick. @param goal [m], `map`
  Twist command(const World& world, RobotId id, const Vector2& goal);

 private:
  RobotPerceiver perceiver_;
  std::vector<HalfPlane> planes_;
};

}  // namespace crowd
