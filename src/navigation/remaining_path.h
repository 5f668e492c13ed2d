#pragma once

#include <vector>

#include "common/span.h"
#include "geometry/geometry.h"
#include "world/agent_map.h"

namespace crowd {

/// @brief Remaining path of an agent: the corners after its position, the last one is the goal [m], `map`.
using RemainingPath = std::vector<Vector2>;

/// @brief Cosine of the angle from which the directions of two ways are opposite.
constexpr double OPPOSITE = -0.3;

/// @brief Length of a remaining path from a place [m].
inline double lengthOf(Span<Vector2> path, Vector2 from) {
  double length = 0.0;
  for (const Vector2& corner : path) {
    length += (corner - from).norm();
    from = corner;
  }
  return length;
}

/// @brief The point of a path at a distance from its start, or its end if it is shorter [m].
/// @param path its corners @param from its start [m]
inline Vector2 pointAlong(Span<Vector2> path, Vector2 from, double distance) {
  for (const Vector2& corner : path) {
    const double length = (corner - from).norm();
    if (length > distance) return from + distance / length * (corner - from);
    distance -= length;
    from = corner;
  }
  return from;
}

}  // namespace crowd
