#include "maps/clearance_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

Eigen::AlignedBox2d boxAround(const FloorPlan& floor) {
  Eigen::AlignedBox2d box;
  for (const Segment& wall : floor.walls) box.extend(wall.from).extend(wall.to);
  for (const FloorPlan::Disc& disc : floor.obstacles) {
    box.extend(disc.centre - Vector2::Constant(disc.radius)).extend(disc.centre + Vector2::Constant(disc.radius));
  }
  return box;
}

}  // namespace

ClearanceGrid::ClearanceGrid(const FloorPlan& floor, double spacing, double limit, const StopRequest& stop)
    : spacing_(spacing), points_per_metre_(1.0 / spacing), limit_(limit) {
  const Eigen::AlignedBox2d bounds = boxAround(floor);
  if (bounds.isEmpty()) return;
  // Discs around the points within the limit of a wall, as large as their clearance, are on the grid.
  const double margin = 2.0 * limit + 3.0 * spacing;
  const Vector2 size = bounds.sizes() + Vector2::Constant(2.0 * margin);
  spacing_ = std::max(spacing, std::sqrt(size.x() * size.y() / static_cast<double>(MAX_POINTS)));
  points_per_metre_ = 1.0 / spacing_;
  origin_ = bounds.min() - Vector2::Constant(margin);
  columns_ = static_cast<Index>(std::ceil(size.x() / spacing_)) + 1;
  rows_ = static_cast<Index>(std::ceil(size.y() / spacing_)) + 1;
  distances_.assign(static_cast<std::size_t>(columns_) * rows_, static_cast<float>(limit));
  for (const Segment& wall : floor.walls) {
    stop.throwIfMade();
    lower(wall.from.cwiseMin(wall.to), wall.from.cwiseMax(wall.to),
          [&](const Vector2& place) { return distanceTo(wall, place); });
  }
  for (const FloorPlan::Disc& disc : floor.obstacles) {
    stop.throwIfMade();
    lower(disc.centre - Vector2::Constant(disc.radius), disc.centre + Vector2::Constant(disc.radius),
          [&](const Vector2& place) { return (place - disc.centre).norm() - disc.radius; });
  }
}

/// Lowers the distances of the grid points within the limit of a box by those to something in the box.
template <typename Distance>
void ClearanceGrid::lower(const Vector2& low, const Vector2& high, const Distance& distance) {
  const auto index = [this](double offset, Index count) {
    return static_cast<Index>(std::clamp(offset / spacing_, 0.0, static_cast<double>(count - 1)));
  };
  const Index left = index(low.x() - limit_ - origin_.x(), columns_);
  const Index right = index(high.x() + limit_ - origin_.x() + spacing_, columns_);
  const Index bottom = index(low.y() - limit_ - origin_.y(), rows_);
  const Index top = index(high.y() + limit_ - origin_.y() + spacing_, rows_);
  for (Index row = bottom; row <= top; ++row) {
    for (Index column = left; column <= right; ++column) {
      const Index point = row * columns_ + column;
      distances_[point] = std::min(distances_[point], static_cast<float>(distance(place(point))));
    }
  }
}

}  // namespace crowd
