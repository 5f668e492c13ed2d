#pragma once

#include "social_crowd/world/geometry.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Later than anything that counts [s].
constexpr double NEVER = 1e9;

/// @brief When a disc touches another one [s]; NEVER if it does not, 0 if it does already and does not part from it.
/// @param place of the other, seen from the disc [m]
/// @param velocity of the disc relative to the other [m/s]
/// @param reach sum of both radii [m]
inline double timeToContact(const Vector2& place, const Vector2& velocity, double reach) {
  const double closing = place.dot(velocity);
  if (closing <= 0.0) return NEVER;
  const double apart = place.squaredNorm() - reach * reach;
  if (apart <= 0.0) return 0.0;
  const double square = velocity.squaredNorm();
  const double inside = closing * closing - square * apart;
  if (inside < 0.0) return NEVER;
  return (closing - std::sqrt(inside)) / square;
}

/// @brief When a disc at the origin touches a wall [s].
double timeToContact(const Segment& wall, const Vector2& velocity, double radius);

/// @brief When an agent would touch anything if it and everybody else went on as they do [s].
/// @param velocity its own, agent frame [m/s]
double timeToContact(const Perception& perception, const Vector2& velocity);

}  // namespace crowd
