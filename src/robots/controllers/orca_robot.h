#pragma once

#include <vector>

#include "robots/controllers/orca.h"
#include "robots/controllers/robot_perceiver.h"

namespace crowd {

/// @brief Drives a robot by optimal reciprocal collision avoidance (orca.h) along the way to its goal.
///
/// People take half of each evasion; walls and obstacles, which recorded people are for a robot, take nothing of it.
/// The wanted velocity leads to the next point of the way at the maximum speed, and slower in the last metre. The
/// velocity becomes a command by steer(). A robot that is not holonomic follows with an error, for which its radius
/// grows by TRACKING_ERROR towards people (Alonso-Mora et al., "Optimal reciprocal collision avoidance for multiple
/// non-holonomic robots", Distributed Autonomous Robotic Systems, 2013); it may touch people nevertheless, as its
/// acceleration is not part of the method.
class OrcaRobot {
 public:
  static constexpr double HORIZON = 3.0;         ///< for people and obstacles that move [s]
  static constexpr double WALL_HORIZON = 1.0;    ///< [s]
  static constexpr double TRACKING_ERROR = 0.1;  ///< of a robot that is not holonomic [m]

  /// @param finds_ways see RobotPerceiver
  OrcaRobot(std::uint64_t episode, bool finds_ways) : perceiver_(episode, finds_ways) {}

  /// @brief The command of the coming tick; call it once a tick. @param goal [m], `map`
  Twist command(const World& world, RobotId id, const Vector2& goal);

 private:
  RobotPerceiver perceiver_;
  std::vector<HalfPlane> planes_;
};

}  // namespace crowd
