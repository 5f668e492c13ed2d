#pragma once

#include "world/neighbours.h"

/// @brief The social force model: Helbing and Molnar, "Social force model for pedestrian dynamics", Physical Review E
/// 51, 1995, with its numbers. There people are points; here the distance to a body is that between the rims. All
/// vectors are in one frame at the robot; forces are per mass [m/s^2].
namespace crowd::social_force {

inline constexpr double RELAXATION_TIME = 0.5;     ///< tau, in which the wanted velocity is reached [s]
inline constexpr double REPULSION = 2.1;           ///< V0, of people [m^2/s^2]
inline constexpr double RANGE = 0.3;               ///< sigma, of the same [m]
inline constexpr double STEP_TIME = 2.0;           ///< Delta t: a person needs the room of its steps in this time [s]
inline constexpr double WALL_REPULSION = 10.0;     ///< U0 [m^2/s^2]
inline constexpr double WALL_RANGE = 0.2;          ///< R [m]
inline constexpr double SIGHT = toRadians(100.0);  ///< phi: half of the angle of sight
inline constexpr double UNSEEN_SHARE = 0.5;        ///< c: weight of what is outside of it

/// @brief The force towards a wanted velocity (2).
Vector2 drivingForce(const Vector2& velocity, const Vector2& wanted);

/// @brief The repulsion of a body (3), (4): -grad of V0 exp(-b / sigma), where b is the small semi-axis of the ellipse
/// through the robot whose foci are the body and its place after Delta t. @param radius of the robot [m]
Vector2 bodyForce(const Neighbour& body, double radius);

/// @brief The repulsion of a wall (5): -grad of U0 exp(-d / R), where d is the distance of its nearest point.
Vector2 wallForce(const Segment& wall);

/// @brief The weight of a repulsion (7): 1 if what repels is within SIGHT of the direction, UNSEEN_SHARE if not.
/// @param direction that the robot wants to go to, any length
double sightWeight(const Vector2& direction, const Vector2& force);

}  // namespace crowd::social_force
