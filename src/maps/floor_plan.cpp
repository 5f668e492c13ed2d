#include "maps/floor_plan.h"

#include <string>

#include "common/text/numbers.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

std::string bracketedText(const Vector2& v) { return "[" + toText(v.x()) + ", " + toText(v.y()) + "]"; }

/// Grows a rectangle; the first point makes it.
void include(std::optional<FloorPlan::Bounds>& bounds, const Vector2& point, double radius) {
  const Vector2 reach = Vector2::Constant(radius + FloorPlan::MARGIN);
  if (!bounds) bounds = FloorPlan::Bounds{point - reach, point + reach};
  bounds->low = bounds->low.cwiseMin(point - reach);
  bounds->high = bounds->high.cwiseMax(point + reach);
}

void check(const Segment& wall, std::size_t number) {
  if (wall.from.allFinite() && wall.to.allFinite()) return;
  throw InputError("floor: wall " + std::to_string(number) + " is from " + bracketedText(wall.from) + " to " +
                   bracketedText(wall.to) + ", expected finite numbers [m]");
}

void check(const FloorPlan::Disc& obstacle, std::size_t number) {
  const std::string name = "floor: obstacle " + std::to_string(number);
  if (!obstacle.centre.allFinite()) {
    throw InputError(name + " is at " + bracketedText(obstacle.centre) + ", expected finite numbers [m]");
  }
  if (!std::isfinite(obstacle.radius) || obstacle.radius < 0.0) {
    throw InputError(name + " has radius " + toText(obstacle.radius) + ", expected a number of at least 0 [m]");
  }
}

void check(const FloorPlan::Bounds& bounds) {
  const bool finite = bounds.low.allFinite() && bounds.high.allFinite();
  if (finite && (bounds.high.array() > bounds.low.array()).all()) return;
  throw InputError("floor: bounds are from " + bracketedText(bounds.low) + " to " + bracketedText(bounds.high) +
                   ", expected finite numbers [m] and an area above 0");
}

}  // namespace

FloorPlan::Bounds FloorPlan::checkedBounds() const {
  std::optional<Bounds> around;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    check(walls[i], i);
    include(around, walls[i].from, 0.0);
    include(around, walls[i].to, 0.0);
  }
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    check(obstacles[i], i);
    include(around, obstacles[i].centre, obstacles[i].radius);
  }
  if (bounds) around = bounds;
  if (!around) throw InputError("floor: no bounds, walls or obstacles, expected at least one of them");
  check(*around);
  return *around;
}

}  // namespace crowd
