#include "geometry/impact.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

/// Maximum penetration of a path that only grazes [m]: rounding must not stop an agent that walks along a wall.
constexpr double GRAZE = 0.1 * TOUCH_TOLERANCE;

/// Whether a path from `distance` to the smaller distance `nearest` penetrates by more than the tolerances.
bool goesDeeper(double distance, double nearest, double reach) {
  return nearest < std::min(reach - GRAZE, distance - LEAST_APPROACH);
}

/// Time of the first impact on the long side of a wall, without its ends.
double firstTouchOfSide(const Segment& wall, const Vector2& way, double reach, double rest) {
  const double length = (wall.to - wall.from).norm();
  const Vector2 along = (wall.to - wall.from) / length;
  const double side = cross(along, -wall.from);  // signed distance to the left of the wall [m]
  const double distance = std::abs(side);
  const double closing = side > 0.0 ? -cross(along, way) : cross(along, way);  // [m] in a tick
  if (closing <= 0.0 || !goesDeeper(distance, distance - rest * closing, reach)) return NO_IMPACT;
  const double time = std::max(0.0, (distance - reach) / closing);
  const double foot = (time * way - wall.from).dot(along);
  return foot >= 0.0 && foot <= length ? time : NO_IMPACT;
}

}  // namespace

double firstTouch(const Vector2& offset, const Vector2& way, double reach, double rest) {
  const double approach = offset.dot(way);
  if (approach <= 0.0) return NO_IMPACT;
  const double way_squared = way.squaredNorm();
  const double distance = offset.norm();
  const double nearest = (offset - std::min(rest, approach / way_squared) * way).norm();
  if (!goesDeeper(distance, nearest, reach)) return NO_IMPACT;
  if (distance <= reach) return 0.0;
  // The smaller root of |offset - time * way| = reach, in the form that avoids cancellation.
  const double excess = (distance - reach) * (distance + reach);
  const double root = std::sqrt(std::max(0.0, approach * approach - way_squared * excess));
  return std::min(rest, excess / (approach + root));
}

double firstTouch(const Segment& wall, const Vector2& way, double reach, double rest) {
  const double ends = std::min(firstTouch(wall.from, way, reach, rest), firstTouch(wall.to, way, reach, rest));
  return std::min(ends, firstTouchOfSide(wall, way, reach, rest));
}

}  // namespace crowd
