#pragma once

#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief Remaining path of an agent: the corners after its position, the last one is the goal [m], `map`.
using RemainingPath = std::vector<Vector2>;

/// @brief Length of a remaining path from a place [m].
inline double lengthOf(const RemainingPath& path, Vector2 from) {
  double length = 0.0;
  for (const Vector2& corner : path) {
    length += (corner - from).norm();
    from = corner;
  }
  return length;
}

}  // namespace crowd
