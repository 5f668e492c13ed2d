#include "social_crowd/world/geometry.h"

#include <algorithm>

namespace crowd {

Vector2 nearestPoint(const Segment& segment, const Vector2& p) {
  const Vector2 along = segment.to - segment.from;
  const double length_squared = along.squaredNorm();
  if (length_squared <= 0.0) return segment.from;
  const double share = std::clamp((p - segment.from).dot(along) / length_squared, 0.0, 1.0);
  return segment.from + share * along;
}

}  // namespace crowd
