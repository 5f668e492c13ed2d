#include "geometry/wall_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/swept_disc.h"

namespace crowd {
namespace {

constexpr double WALL_CELL_SIZE = 1.0;  // wanted [m]
constexpr double MAX_CELLS = 1U << 20U;
constexpr std::size_t ENTRIES_PER_WALL = 64;  // more than that, and cells are made larger,
constexpr std::size_t FREE_ENTRIES = 65536;   // which are allowed in any case
constexpr double SLACK = 1e-6;                // [cells]; walls so near to a cell are also in it, against rounding

/// Whether a wall is within a distance of a point. It has no branches, because in a search they would be mispredicted
/// often, and no division.
/// @param limit square of the distance [m2]
bool isWithin(double limit, const Segment& wall, const Vector2& point) {
  const Vector2 along = wall.to - wall.from;
  const Vector2 offset = point - wall.from;
  const double length_squared = along.squaredNorm();
  const double walked = offset.dot(along);
  const double aside = cross(along, offset);
  const bool is_beside = (walked > 0.0) & (walked < length_squared);
  const bool is_near_line = aside * aside <= limit * length_squared;
  return (is_beside & is_near_line) | (offset.squaredNorm() <= limit) | ((point - wall.to).squaredNorm() <= limit);
}

/// The square of the distance to the point that nearestPoint() gives.
double squaredDistance(const Segment& wall, const Vector2& point) {
  const Vector2 along = wall.to - wall.from;
  const double length_squared = std::max(along.squaredNorm(), std::numeric_limits<double>::min());
  const double share = (point - wall.from).dot(along) / length_squared;
  return (wall.from + std::min(std::max(share, 0.0), 1.0) * along - point).squaredNorm();
}

/// The x coordinates of the part of a segment between two y coordinates; if there is none, of its nearer end.
std::pair<double, double> xsBetween(const Segment& segment, double low, double high) {
  const Vector2 along = segment.to - segment.from;
  const auto x_at = [&](double y) {
    return segment.from.x() + std::clamp((y - segment.from.y()) / along.y(), 0.0, 1.0) * along.x();
  };
  const bool is_level = along.y() == 0.0;
  return std::minmax(is_level ? segment.from.x() : x_at(low), is_level ? segment.to.x() : x_at(high));
}

}  // namespace

WallIndex::WallIndex(std::vector<Segment> walls, double margin) : walls_(std::move(walls)), margin_(margin) {
  if (isList()) return;
  layOut();
  fillCells();
}

std::int64_t WallIndex::cellOf(double offset, std::int64_t cells) const {
  const double cell = offset * cells_per_metre_;
  return cell > 0.0 ? static_cast<std::int64_t>(std::min(cell, static_cast<double>(cells - 1))) : 0;
}

WallIndex::Cells WallIndex::cellsNear(const Vector2& point, double distance) const {
  const double reach = distance <= margin_ ? 0.0 : distance;
  return {column(point.x() - reach), column(point.x() + reach), row(point.y() - reach), row(point.y() + reach)};
}

template <typename Visit>
bool WallIndex::visitRows(const Segment& segment, double margin, const Visit& visit) const {
  const double reach = margin + SLACK / cells_per_metre_;
  const auto [low, high] = std::minmax(segment.from.y(), segment.to.y());
  for (std::int64_t r = row(low - reach); r <= row(high + reach); ++r) {
    const double bottom = origin_.y() + static_cast<double>(r) / cells_per_metre_;
    const auto [left, right] = xsBetween(segment, bottom - reach, bottom + 1.0 / cells_per_metre_ + reach);
    if (visit(r, column(left - reach), column(right + reach))) return true;
  }
  return false;
}

Span<std::uint32_t> WallIndex::wallsInRow(std::int64_t row, std::int64_t left, std::int64_t right) const {
  const auto cells = first_.begin() + row * columns_;
  const std::uint32_t begin = *(cells + left);
  return {entries_.data() + begin, *(cells + right + 1) - begin};
}

template <typename Test>
bool WallIndex::isAnyNear(const Vector2& point, double distance, const Test& test) const {
  if (isList()) {
    for (std::uint32_t i = 0; i < walls_.size(); ++i) {
      if (test(i)) return true;
    }
    return false;
  }
  const Cells cells = cellsNear(point, distance);
  for (std::int64_t r = cells.bottom; r <= cells.top; ++r) {
    const Span<std::uint32_t> walls = wallsInRow(r, cells.left, cells.right);
    if (std::any_of(walls.begin(), walls.end(), test)) return true;
  }
  return false;
}

void WallIndex::layOut() {
  Vector2 low = walls_.front().from;
  Vector2 high = low;
  for (const Segment& wall : walls_) {
    low = low.cwiseMin(wall.from).cwiseMin(wall.to);
    high = high.cwiseMax(wall.from).cwiseMax(wall.to);
  }
  origin_ = low;
  const Vector2 size = high - low;
  cells_per_metre_ = 1.0 / WALL_CELL_SIZE;
  const auto count = [&](double side) { return std::isfinite(side) ? side * cells_per_metre_ + 1.0 : 1.0; };
  while (count(size.x()) * count(size.y()) > MAX_CELLS) cells_per_metre_ /= 2.0;
  const auto resize = [&] {
    columns_ = static_cast<std::int64_t>(count(size.x()));
    rows_ = static_cast<std::int64_t>(count(size.y()));
  };
  for (resize(); countEntries() > ENTRIES_PER_WALL * walls_.size() + FREE_ENTRIES; resize()) cells_per_metre_ /= 2.0;
}

std::size_t WallIndex::countEntries() const {
  std::size_t entries = 0;
  for (const Segment& wall : walls_) {
    visitRows(wall, margin_, [&](std::int64_t /*row*/, std::int64_t left, std::int64_t right) {
      entries += static_cast<std::size_t>(right - left + 1);
      return false;
    });
  }
  return entries;
}

void WallIndex::fillCells() {
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 2, 0);
  const auto visit_cells = [&](const Segment& wall, const auto& visit) {
    visitRows(wall, margin_, [&](std::int64_t r, std::int64_t left, std::int64_t right) {
      for (std::int64_t c = left; c <= right; ++c) visit(static_cast<std::size_t>(r * columns_ + c));
      return false;
    });
  };
  for (const Segment& wall : walls_) visit_cells(wall, [&](std::size_t cell) { ++first_[cell + 2]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  entries_.resize(first_.back());
  // first_[c + 1] is the start of cell c, and advances to its end.
  for (std::uint32_t i = 0; i < walls_.size(); ++i) {
    visit_cells(walls_[i], [&](std::size_t cell) { entries_[first_[cell + 1]++] = i; });
  }
}

void WallIndex::findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const {
  if (!(distance >= 0.0)) return;
  const double limit = distance * distance;
  if (isList()) {
    for (std::uint32_t i = 0; i < walls_.size(); ++i) {
      if (isWithin(limit, walls_[i], point)) found.push_back(i);
    }
    return;
  }
  const std::size_t before = found.size();
  std::size_t count = before;
  const Cells cells = cellsNear(point, distance);
  for (std::int64_t r = cells.bottom; r <= cells.top; ++r) {
    const Span<std::uint32_t> walls = wallsInRow(r, cells.left, cells.right);
    found.resize(count + walls.size());
    for (const std::uint32_t wall : walls) {
      found[count] = wall;  // stays if the wall is near
      count += isWithin(limit, walls_[wall], point) ? 1 : 0;
    }
  }
  found.resize(count);
  if (cells.left == cells.right && cells.bottom == cells.top) return;
  const auto begin = found.begin() + static_cast<std::ptrdiff_t>(before);
  std::sort(begin, found.end());
  found.erase(std::unique(begin, found.end()), found.end());
}

bool WallIndex::isAnyOfWallsWithin(const Vector2& point, double distance) const {
  if (!(distance >= 0.0)) return false;
  const double limit = distance * distance;
  return isAnyNear(point, distance, [&](std::uint32_t wall) { return isWithin(limit, walls_[wall], point); });
}

double WallIndex::nearestDistance(const Vector2& point, double limit) const {
  if (!(limit > 0.0)) return limit;
  double nearest = limit * limit;
  const auto look = [&](std::uint32_t wall) {
    nearest = std::min(nearest, squaredDistance(walls_[wall], point));
    return false;
  };
  // The reach is doubled until it contains the nearest wall or all cells.
  for (double reach = isList() ? limit : 1.0 / cells_per_metre_;; reach *= 2.0) {
    reach = std::min(reach, limit);
    isAnyNear(point, reach, look);
    if (reach >= limit || nearest <= reach * reach) break;
  }
  return std::min(limit, std::sqrt(nearest));
}

bool WallIndex::isClear(const Vector2& from, const Vector2& to, double radius) const {
  const SweptDisc disc({from, to}, radius);
  const auto overlaps = [&](std::uint32_t wall) { return disc.overlaps(walls_[wall]); };
  if (isList()) return !isAnyNear(from, 0.0, overlaps);
  return !visitRows({from, to}, radius, [&](std::int64_t r, std::int64_t left, std::int64_t right) {
    const Span<std::uint32_t> walls = wallsInRow(r, left, right);
    return std::any_of(walls.begin(), walls.end(), overlaps);
  });
}

std::size_t WallIndex::memory() const {
  return walls_.capacity() * sizeof(Segment) + (first_.capacity() + entries_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace crowd
