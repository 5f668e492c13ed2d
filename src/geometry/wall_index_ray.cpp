// The first wall on a ray: the cells on it are visited in their order (Amanatides and Woo 1987).

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/ray.h"
#include "geometry/wall_index.h"

namespace crowd {
namespace {

/// The part of a ray within 0 .. size on one axis, in steps of the ray; empty if begin > end.
struct Part {
  double begin = 0.0;
  double end = INFINITE;
};

void clip(double start, double slope, double size, Part& part) {
  if (slope == 0.0) {
    if (start < 0.0 || start > size) part.end = -1.0;
    return;
  }
  const auto [enter, leave] = std::minmax({-start / slope, (size - start) / slope});
  part.begin = std::max(part.begin, enter);
  part.end = std::min(part.end, leave);
}

/// Cells of one axis along a ray, in units of cells.
struct Axis {
  Axis(double start, double slope, double begin, std::int64_t cells)
      : cell(std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor(start + slope * begin)), 0, cells - 1)),
        step(slope > 0.0 ? 1 : -1),
        per_cell(slope == 0.0 ? INFINITE : 1.0 / std::abs(slope)),
        next(slope == 0.0 ? INFINITE : (static_cast<double>(cell + (slope > 0.0 ? 1 : 0)) - start) / slope) {}

  /// Goes on to the next cell. Beyond the last one there are only walls that lie on its edge, so the ray stays in it.
  void advance(std::int64_t cells) {
    const bool is_last = cell + step < 0 || cell + step >= cells;
    cell += is_last ? 0 : step;
    next = is_last ? INFINITE : next + per_cell;
  }

  std::int64_t cell;
  std::int64_t step;
  double per_cell;  // length of the ray from one cell to the next
  double next;      // length of the ray up to the end of the cell
};

}  // namespace

double WallIndex::firstHit(const Ray& ray, double limit) const {
  double nearest = limit;
  const auto look = [&](std::uint32_t wall) { nearest = std::min(nearest, distanceAlong(ray, walls_[wall])); };
  if (isList()) {
    for (std::uint32_t i = 0; i < walls_.size(); ++i) look(i);
    return nearest;
  }
  const Vector2 start = (ray.origin - origin_) * cells_per_metre_;
  Part part;
  // All walls lie within these sides, which are wider by one cell against rounding.
  clip(start.x() + 1.0, ray.unit.x(), static_cast<double>(columns_) + 2.0, part);
  clip(start.y() + 1.0, ray.unit.y(), static_cast<double>(rows_) + 2.0, part);
  Axis x(start.x(), ray.unit.x(), part.begin, columns_);
  Axis y(start.y(), ray.unit.y(), part.begin, rows_);
  for (double begin = part.begin; begin <= std::min(part.end, nearest * cells_per_metre_);) {
    for (const std::uint32_t wall : wallsInRow(y.cell, x.cell, x.cell)) look(wall);
    begin = std::min(x.next, y.next);
    if (x.next < y.next) {
      x.advance(columns_);
    } else {
      y.advance(rows_);
    }
  }
  return nearest;
}

}  // namespace crowd
