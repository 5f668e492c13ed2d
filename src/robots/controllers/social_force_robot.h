#pragma once

#include "robots/controllers/robot_perceiver.h"
#include "robots/controllers/social_force.h"

namespace crowd {

/// @brief Drives a robot by the social force model (social_force.h) along the way to its goal.
///
/// The sum of the forces of a tick changes the robot's velocity, which is limited to its maximum speed and becomes a
/// command by steer(). Of the walls, only the nearest one repels, as in the paper.
class SocialForceRobot {
 public:
  /// @param finds_ways see RobotPerceiver
  SocialForceRobot(std::uint64_t episode, bool finds_ways) : perceiver_(episode, finds_ways) {}

  /// @brief The command of the coming tick; call it once a tick. @param goal [m], `map`
  Twist command(const World& world, RobotId id, const Vector2& goal);

 private:
  RobotPerceiver perceiver_;
};

}  // namespace crowd
