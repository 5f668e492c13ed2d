#include "maps/floor_reach.h"

namespace crowd {
namespace {

/// Where an agent fits.
std::vector<bool> fitsIn(const ClearanceGrid& grid, double clearance) {
  std::vector<bool> fits(grid.size());
  for (ClearanceGrid::Index point = 0; point < grid.size(); ++point) fits[point] = grid[point] >= clearance;
  return fits;
}

}  // namespace

double FloorReach::pointsOf(const FloorPlan& floor) {
  const FloorPlan::Bounds bounds = floor.checkedBounds();
  const Vector2 points = (bounds.high - bounds.low) / SPACING;
  return points.x() * points.y();
}

FloorReach::FloorReach(const FloorPlan& floor, double radius, const StopRequest& stop)
    : search_distance_(radius + ROOM + SPACING),
      grid_(floor, SPACING, search_distance_, stop),
      components_(grid_, fitsIn(grid_, radius + ROOM), stop) {}

bool FloorReach::connects(const Vector2& from, const Vector2& to) const {
  const std::uint32_t start = component(from);
  const std::uint32_t end = component(to);
  return start == end || start == GridComponents::NONE || end == GridComponents::NONE;
}

/// The component at a place or, beside walls, near it. The floor beyond the grid is connected with its edge.
std::uint32_t FloorReach::component(const Vector2& place) const {
  const ClearanceGrid::Index point = grid_.nearest(place);
  if (point == ClearanceGrid::OUTSIDE) return components_.numbers.front();
  std::uint32_t found = components_.numbers[point];
  if (found != GridComponents::NONE) return found;
  double least = search_distance_;  // the nearest one is on the same side of a wall
  grid_.forPointsWithin(least, point, [&](ClearanceGrid::Index near) {
    const double distance = (grid_.place(near) - place).norm();
    if (components_.numbers[near] == GridComponents::NONE || distance > least) return;
    least = distance;
    found = components_.numbers[near];
  });
  return found;
}

}  // namespace crowd
