#pragma once

#include <vector>

#include "geometry/footprint.h"

namespace crowd {

/// @brief How a robot may slide along walls.
struct WallSliding {
  double max_rotation = 0.0;       ///< to which a wall may turn it [rad/s]
  bool turns_on_the_spot = false;  ///< else it turns in proportion to its speed, as a car
};

/// @brief A point of a footprint's rim that touches a wall.
struct WallContact {
  Vector2 arm = Vector2::Zero();     ///< from the robot's position to the point [m], `map`
  Vector2 normal = Vector2::Zero();  ///< unit vector into the wall, or out of the footprint, `map`
};

/// @brief Motion of a rigid body: velocity of its position [m/s], `map`, and rotation [rad/s].
struct BodyMotion {
  Vector2 velocity = Vector2::Zero();
  double rotation = 0.0;
};

/// @brief Appends the points of a footprint that are nearer to a wall than a tolerance [m]; one of a disc, at most two
/// of a straight side.
void addContacts(const Footprint& footprint, const Pose& pose, const Segment& wall, double tolerance,
                 std::vector<WallContact>& contacts);

/// @brief The motion of a robot that touches walls without friction, and does not bounce off them: what a rigid body
/// keeps of its motion after an inelastic impact at each contact. A disc slides and turns as it did; a wall also turns
/// other footprints. It leads into none of the walls for a time, or is zero where no such motion is found.
/// @param motion in which it met the walls @param time for which it is to hold [s]
BodyMotion slideAlongWalls(const Footprint& footprint, const std::vector<WallContact>& contacts,
                           const BodyMotion& motion, const WallSliding& sliding, double time);

}  // namespace crowd
