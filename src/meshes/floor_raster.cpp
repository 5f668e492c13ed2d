#include "meshes/floor_raster.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crowd {
namespace {

/// Number of cells along an edge of the floor.
int cellsAlong(double length, double cell_size) {
  return std::max(1, static_cast<int>(std::ceil(length / cell_size - 1e-6)));
}

/// Cell of a coordinate [cells], within 0 .. count.
int clampedCell(double coordinate, int count) {
  return static_cast<int>(std::clamp(std::floor(coordinate), 0.0, static_cast<double>(count)));
}

/// The part of a segment within a rectangle; std::nullopt if there is none.
std::optional<Segment> clip(const Segment& segment, const Vector2& low, const Vector2& high) {
  const Vector2 way = segment.to - segment.from;
  double first = 0.0;
  double last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    if (way[axis] == 0.0) {
      if (segment.from[axis] < low[axis] || segment.from[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double to_low = (low[axis] - segment.from[axis]) / way[axis];
    const double to_high = (high[axis] - segment.from[axis]) / way[axis];
    first = std::max(first, std::min(to_low, to_high));
    last = std::min(last, std::max(to_low, to_high));
  }
  if (first > last) return std::nullopt;
  return Segment{segment.from + first * way, segment.from + last * way};
}

}  // namespace

FloorRaster::FloorRaster(const FloorPlan& plan, const FloorPlan::Bounds& bounds, double clearance, double cell_size,
                         const StopRequest& stop)
    : origin_(bounds.low),
      cell_size_(cell_size),
      columns_(cellsAlong(bounds.high.x() - bounds.low.x(), cell_size)),
      rows_(cellsAlong(bounds.high.y() - bounds.low.y(), cell_size)),
      free_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 1) {
  constexpr double PIECE = 64.0;  // [cells]; long walls are cut, because each piece tests all cells around it
  const double reach = clearance / cell_size + EXTRA;
  const Vector2 margin = Vector2::Constant(reach + 1.0);
  for (const Segment& wall : plan.walls) {
    stop.throwIfMade();
    const Segment in_cells{(wall.from - origin_) / cell_size, (wall.to - origin_) / cell_size};
    const std::optional<Segment> part = clip(in_cells, -margin, Vector2(columns_, rows_) + margin);
    if (!part) continue;
    const Vector2 way = part->to - part->from;
    const double count = std::max(1.0, std::ceil(way.norm() / PIECE));
    for (double i = 0.0; i < count; ++i)
      block({part->from + i / count * way, part->from + (i + 1.0) / count * way}, reach);
  }
  for (const FloorPlan::Disc& obstacle : plan.obstacles) {
    stop.throwIfMade();
    const Vector2 centre = (obstacle.centre - origin_) / cell_size;
    block({centre, centre}, obstacle.radius / cell_size + reach);
  }
}

void FloorRaster::block(const Segment& piece, double distance) {
  const Vector2 low = piece.from.cwiseMin(piece.to) - Vector2::Constant(distance);
  const Vector2 high = piece.from.cwiseMax(piece.to) + Vector2::Constant(distance);
  const int last_column = clampedCell(high.x() + 1.0, columns_);
  const int last_row = clampedCell(high.y() + 1.0, rows_);
  const Vector2 way = piece.to - piece.from;
  const double per_square = way.squaredNorm() > 0.0 ? 1.0 / way.squaredNorm() : 0.0;
  for (int row = clampedCell(low.y(), rows_); row < last_row; ++row) {
    for (int column = clampedCell(low.x(), columns_); column < last_column; ++column) {
      const Vector2 offset = Vector2(column + 0.5, row + 0.5) - piece.from;
      const double share = std::clamp(offset.dot(way) * per_square, 0.0, 1.0);
      if ((offset - share * way).squaredNorm() < distance * distance) free_[index(column, row)] = 0;
    }
  }
}

}  // namespace crowd
