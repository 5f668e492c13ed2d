#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/geometry.h"

namespace crowd {

/// @brief A ray: its origin and unit vector [m], `map`.
struct Ray {
  Vector2 origin = Vector2::Zero();
  Vector2 unit = Vector2::UnitX();
};

/// @brief Distance along the ray to the rim of a disc [m]; 0 if the origin lies in the disc, infinity if the ray misses
/// it.
inline double distanceAlong(const Ray& ray, const Vector2& centre, double radius) {
  const Vector2 offset = centre - ray.origin;
  if (offset.squaredNorm() <= radius * radius) return 0.0;
  const double ahead = offset.dot(ray.unit);
  const double aside = cross(ray.unit, offset);
  const double square = radius * radius - aside * aside;
  return ahead > 0.0 && square >= 0.0 ? ahead - std::sqrt(square) : INFINITE;
}

/// @brief Distance along the ray to a segment, ends included [m]; infinity if the ray misses it. A ray along the
/// segment hits its nearer end.
inline double distanceAlong(const Ray& ray, const Segment& segment) {
  constexpr double END_TOLERANCE = 1e-12;  // share of the segment: no ray slips between two walls that share an end
  constexpr double PARALLEL = 1e-12;       // sine of an angle: rounding hides where nearly parallel ones would meet
  constexpr double BESIDE = 1e-9;          // up to this distance a parallel segment lies on the ray [m]
  const Vector2 along = segment.to - segment.from;
  const Vector2 offset = segment.from - ray.origin;
  const double slope = cross(ray.unit, along);
  const double walked = cross(offset, ray.unit);
  if (slope * slope <= PARALLEL * PARALLEL * along.squaredNorm()) {
    if (std::abs(walked) > BESIDE) return INFINITE;
    const double from = offset.dot(ray.unit);
    const double to = from + along.dot(ray.unit);
    return std::max(from, to) < 0.0 ? INFINITE : std::max(0.0, std::min(from, to));
  }
  const double length = std::abs(slope);
  const double share = slope > 0.0 ? walked : -walked;  // of the segment, times length
  const double ahead = slope > 0.0 ? cross(offset, along) : -cross(offset, along);
  const double tolerance = END_TOLERANCE * length;
  const bool is_hit = (share >= -tolerance) & (share <= length + tolerance) & (ahead >= 0.0);
  return is_hit ? ahead / length : INFINITE;
}

}  // namespace crowd
