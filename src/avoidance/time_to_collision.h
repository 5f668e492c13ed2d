#pragma once

#include <array>
#include <cstddef>

#include "avoidance/candidate_move.h"
#include "geometry/geometry.h"
#include "world/perception.h"

namespace crowd {

/// @brief Stands for no collision; later than any time that is considered [s].
constexpr double NEVER = 1e9;

/// @brief Returns the time until a disc touches another one [s]; NEVER if it does not, 0 if they overlap and approach.
/// Compiles without branches, so that loops over it can be vectorised.
/// @param x, y position of the other relative to the disc [m]
/// @param vx, vy velocity of the disc relative to the other [m/s]
/// @param reach sum of the radii [m]
inline double timeToCollision(double x, double y, double vx, double vy, double reach) {
  const double closing = x * vx + y * vy;
  const double apart = (x * x + y * y) - reach * reach;
  const double square = vx * vx + vy * vy;
  const double inside = closing * closing - square * apart;
  const double met = (closing - std::sqrt(inside)) / square;
  const double ahead = inside < 0.0 ? NEVER : met;
  const double closer = apart <= 0.0 ? 0.0 : ahead;
  return closing <= 0.0 ? NEVER : closer;
}
/// @brief The same with vectors.
inline double timeToCollision(const Vector2& place, const Vector2& velocity, double reach) {
  return timeToCollision(place.x(), place.y(), velocity.x(), velocity.y(), reach);
}

/// @brief Returns the time until a disc at the origin touches a wall [s]; NEVER if it does not.
/// @param velocity velocity of the disc [m/s]
/// @param radius radius of the disc [m]
double timeToCollision(const Segment& wall, const Vector2& velocity, double radius);

/// @brief Returns the time until an agent touches a neighbour or a wall if all velocities stay constant [s]; NEVER if
/// it does not.
/// @param velocity velocity of the agent, agent frame [m/s]
double timeToCollision(const Perception& perception, const Vector2& velocity);

/// @brief Velocities that an agent chooses among, and the time to collision of each. Times are stored as inverses,
/// 1 / time [1/s], and belong to the soonest collision that was found so far.
///
/// Call contract: the caller writes `count`, `xs` and `ys` and calls clear(); each call of accumulateTimeToCollision()
/// then updates the other members.
struct CandidateVelocities {
  static constexpr std::size_t LANES = MoveBlock::SIZE;
  using Lanes = std::array<float, LANES>;

  std::size_t count;                    ///< number of velocities; the lanes after them hold arbitrary finite values
  alignas(64) Lanes xs;                 ///< x components, agent frame [m/s]
  alignas(64) Lanes ys;                 ///< y components, agent frame [m/s]
  alignas(64) Lanes reciprocal;         ///< reciprocal time with agents (van den Berg et al. 2008), as 1 / (2 time)
  alignas(64) Lanes constant_velocity;  ///< with agents, if they keep their velocities
  alignas(64) Lanes static_bodies;      ///< with obstacles and walls; valid if any_static
  float fastest;    ///< square of the fastest approach of an agent, for the preferred velocity [m2/s2]
  bool any_static;  ///< whether an obstacle or a wall was found

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): the caller writes them, and zeroing takes time
  CandidateVelocities() = default;
  /// @brief Resets the results to no collision.
  void clear() {
    fastest = 0.0F;
    any_static = false;
    for (Lanes* times : {&reciprocal, &constant_velocity}) times->fill(static_cast<float>(1.0 / NEVER));
  }
  /// @brief Sets any_static; at the first call also initialises static_bodies.
  void beginFixed() {
    if (!any_static) static_bodies.fill(static_cast<float>(1.0 / NEVER));
    any_static = true;
  }
};

/// @brief Updates the times to collision of the candidates with all neighbours and walls of a perception, in single
/// precision. Robots with a comfort (RobotIntent) count as larger by it, as far as that leaves a part of the room
/// behind the agent, and as if they went on at the velocity that they want.
/// @param preferred the velocity straight to the goal at maximum speed, agent frame [m/s]
/// @param personal_space by which other agents count as larger, as far as that leaves a part of the gap to the nearest
/// one [m]
void accumulateTimeToCollision(const Perception& seen, const Vector2& preferred, double personal_space,
                               CandidateVelocities& candidates);

}  // namespace crowd
