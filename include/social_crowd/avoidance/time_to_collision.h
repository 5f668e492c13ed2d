#pragma once

#include <array>
#include <cstddef>

#include "social_crowd/avoidance/candidate_move.h"
#include "social_crowd/world/geometry.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Later than anything that counts [s].
constexpr double NEVER = 1e9;

/// @brief When a disc touches another one [s]; NEVER if it does not, 0 if it does already and does not part from it.
/// No branch depends on the numbers.
/// @param x, y place of the other, seen from the disc [m]
/// @param vx, vy velocity of the disc relative to the other [m/s]
/// @param reach sum of both radii [m]
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
inline double timeToCollision(const Vector2& place, const Vector2& velocity, double reach) {
  return timeToCollision(place.x(), place.y(), velocity.x(), velocity.y(), reach);
}

/// @brief When a disc at the origin touches a wall [s].
double timeToCollision(const Segment& wall, const Vector2& velocity, double radius);

/// @brief When an agent would touch anything if it and everybody else went on as they do [s].
/// @param velocity its own, agent frame [m/s]
double timeToCollision(const Perception& perception, const Vector2& velocity);

/// @brief Velocities that an agent chooses among, and how soon it would collide with each. Times are kept as their
/// inverses, 1 / time [1/s], and are those of the soonest collision that was found so far.
struct CandidateVelocities {
  static constexpr std::size_t LANES = MoveBlock::SIZE;
  using Lanes = std::array<float, LANES>;

  std::size_t count;     ///< lanes behind the first so many hold anything finite
  alignas(64) Lanes xs;  ///< [m/s]
  alignas(64) Lanes ys;
  alignas(64) Lanes reciprocal;         ///< with agents that do half of what is needed, in half of the time
  alignas(64) Lanes constant_velocity;  ///< with agents that keep their velocities
  alignas(64) Lanes static_bodies;      ///< with obstacles and walls, once any_static
  float fastest;    ///< square of the fastest approach of another agent if this one had its preferred velocity [m2/s2]
  bool any_static;  ///< whether there is an obstacle or a wall

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): whoever makes them writes them, and zeroing takes time
  CandidateVelocities() = default;
  /// @brief Nothing was found so far.
  void clear() {
    fastest = 0.0F;
    any_static = false;
    for (Lanes* times : {&reciprocal, &constant_velocity}) times->fill(static_cast<float>(1.0 / NEVER));
  }
  /// @brief There is an obstacle or a wall.
  void beginFixed() {
    if (!any_static) static_bodies.fill(static_cast<float>(1.0 / NEVER));
    any_static = true;
  }
};

/// @brief Finds collisions with everything that an agent perceives, in single precision.
/// @param preferred the velocity that it would have if nobody were there [m/s]
void accumulateTimeToCollision(const Perception& seen, const Vector2& preferred, CandidateVelocities& candidates);

}  // namespace crowd
