#include "robots/metrics/walkable_area.h"

#include <algorithm>

#include "maps/clearance_grid.h"
#include "maps/grid_components.h"
#include "navigation/walking_floor.h"

namespace crowd {
namespace {

bool isAtEdge(const ClearanceGrid& grid, ClearanceGrid::Index point) {
  const ClearanceGrid::Index column = point % grid.columns();
  const ClearanceGrid::Index row = point / grid.columns();
  return column == 0 || row == 0 || column + 1 == grid.columns() || row + 1 == grid.rows();
}

}  // namespace

WalkableArea::WalkableArea(const ObservedScene& scene, const std::vector<Segment>& gates, const Vector2& place)
    : floor_(floorOf(scene, gates)), place_(place) {}

double WalkableArea::size(const Eigen::AlignedBox2d& used) const {
  const double rectangle = used.isEmpty() ? 0.0 : used.volume();
  if (!hasBarriers(floor_)) return rectangle;
  if (!points_) points_ = search();
  if (points_->are_enclosed) return points_->cell * static_cast<double>(points_->list.size());
  const auto count = std::count_if(points_->list.begin(), points_->list.end(),
                                   [&](const Vector2& point) { return used.contains(point); });
  const Eigen::AlignedBox2d searched = used.intersection(points_->grid);
  return points_->cell * static_cast<double>(count) + rectangle - (searched.isEmpty() ? 0.0 : searched.volume());
}

WalkableArea::Points WalkableArea::search() const {
  const ClearanceGrid grid(floor_, SPACING, 2.0 * MARGIN);
  std::vector<bool> fits(grid.size());
  for (ClearanceGrid::Index point = 0; point < grid.size(); ++point) fits[point] = grid[point] >= MARGIN;
  const std::vector<std::uint32_t> numbers = GridComponents(grid, fits).numbers;
  const ClearanceGrid::Index start = grid.nearest(place_);
  // The floor beyond the grid is connected with its edge.
  const std::uint32_t component = start == ClearanceGrid::OUTSIDE ? numbers.front() : numbers[start];
  Points points;
  points.cell = grid.spacing() * grid.spacing();
  points.grid = Eigen::AlignedBox2d(grid.place(0), grid.place(static_cast<ClearanceGrid::Index>(grid.size() - 1)));
  points.are_enclosed = true;
  for (ClearanceGrid::Index point = 0; point < grid.size(); ++point) {
    if (component == GridComponents::NONE || numbers[point] != component) continue;
    points.list.push_back(grid.place(point));
    points.are_enclosed = points.are_enclosed && !isAtEdge(grid, point);
  }
  return points;
}

}  // namespace crowd
