#include "geometry/closest_points.h"

#include <array>

namespace crowd {
namespace {

/// A segment as a point and a way from there; the reciprocal of a length of 0 is 0.
struct Way {
  explicit Way(const Segment& segment) : from(segment.from), way(segment.to - segment.from) {
    const double square = way.squaredNorm();
    per_square = square > 0.0 ? 1.0 / square : 0.0;
  }
  Vector2 nearestTo(const Vector2& point) const {
    return from + std::clamp((point - from).dot(way) * per_square, 0.0, 1.0) * way;
  }

  Vector2 from;
  Vector2 way;
  double per_square;
};

/// Whether the ends of a segment are on different sides of the line of the other one.
bool isOnBothSides(const Way& line, const Segment& segment) {
  return cross(line.way, segment.from - line.from) * cross(line.way, segment.to - line.from) < 0.0;
}

}  // namespace

/// Segments of the plane that do not cross are closest at an end of one of them.
ClosestPoints closestPoints(const Segment& first, const Segment& second) {
  const Way one(first);
  const Way other(second);
  if (isOnBothSides(one, second) && isOnBothSides(other, first)) {
    const double denominator = cross(one.way, other.way);
    if (denominator != 0.0) {
      const double share = std::clamp(cross(other.from - one.from, other.way) / denominator, 0.0, 1.0);
      const Vector2 common = one.from + share * one.way;
      return {common, common};
    }
  }
  const std::array<ClosestPoints, 4> ends = {{{first.from, other.nearestTo(first.from)},
                                              {first.to, other.nearestTo(first.to)},
                                              {one.nearestTo(second.from), second.from},
                                              {one.nearestTo(second.to), second.to}}};
  std::size_t closest = 0;
  double smallest = INFINITE;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const double square = (ends[i].of_second - ends[i].of_first).squaredNorm();
    closest = square < smallest ? i : closest;
    smallest = std::min(square, smallest);
  }
  return ends[closest];
}

}  // namespace crowd
