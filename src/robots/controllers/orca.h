#pragma once

#include <vector>

#include "world/neighbours.h"

namespace crowd {

/// @brief The velocities v with (v - point) . normal >= 0 [m/s].
struct HalfPlane {
  Vector2 point = Vector2::Zero();
  Vector2 normal = Vector2::Zero();  ///< unit vector into it
};

/// @brief Optimal reciprocal collision avoidance: van den Berg, Guy, Lin and Manocha, "Reciprocal n-body collision
/// avoidance", Robotics Research, 2011. All vectors are in one frame at the robot.
namespace orca {

/// @brief The velocities that avoid a body for a time, if the body does its share (section 4). The velocity obstacle is
/// the set of relative velocities that lead to a contact within `horizon`: a cone that a disc of radius
/// (radius + body.radius) / horizon about body.position / horizon cuts off. u is the smallest change of the relative
/// velocity that leads to its boundary, and the half-plane begins at velocity + share * u, with the outward normal.
/// Bodies that overlap are to part within a tick, which is their horizon.
/// @param radius of the robot [m] @param velocity of the robot [m/s] @param share of u that the robot takes: 1/2 if the
/// body avoids it, too, and 1 if not @param horizon [s] @param tick [s]
HalfPlane avoid(const Neighbour& body, double radius, const Vector2& velocity, double share, double horizon,
                double tick);

/// @brief The velocities that do not lead to a wall within a time (section 5.3, with the optimisation velocity 0): the
/// speed towards its nearest point is at most the distance from the rim / horizon, or away from it within a tick if the
/// robot overlaps it. Standing is permitted, unless it overlaps.
HalfPlane avoid(const Segment& wall, double radius, double horizon, double tick);

/// @brief The velocity of at most `max_speed` in all half-planes that is nearest to the wanted one: an incremental
/// linear program (section 5.3). If there is none, that which is least deep outside of the half-planes after the first
/// `fixed` ones, which hold as long as those have a common velocity (a linear program in three dimensions).
/// @param planes in the order in which they are added
Vector2 nearestVelocity(const std::vector<HalfPlane>& planes, std::size_t fixed, double max_speed,
                        const Vector2& wanted);

}  // namespace orca
}  // namespace crowd
