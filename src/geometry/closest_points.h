#pragma once

#include "geometry/geometry.h"

namespace crowd {

/// @brief Points of two segments whose distance is the smallest [m].
struct ClosestPoints {
  Vector2 of_first;
  Vector2 of_second;
};

/// @brief Finds them; for segments that cross, their common point twice.
ClosestPoints closestPoints(const Segment& first, const Segment& second);

}  // namespace crowd
