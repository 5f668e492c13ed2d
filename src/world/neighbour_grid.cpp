#include "social_crowd/world/neighbour_grid.h"

#include <algorithm>

namespace crowd {

void NeighbourGrid::clear() {
  discs_.clear();
  max_radius_ = 0.0;
}

void NeighbourGrid::add(const Vector2& centre, double radius, std::uint32_t body) {
  discs_.push_back({centre, radius, body});
  max_radius_ = std::max(max_radius_, radius);
}

std::int64_t NeighbourGrid::column(double x) const {
  const double cell = std::floor((x - origin_.x()) / cell_size_);
  return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(columns_ - 1)));
}

std::int64_t NeighbourGrid::row(double y) const {
  const double cell = std::floor((y - origin_.y()) / cell_size_);
  return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(rows_ - 1)));
}

void NeighbourGrid::build(double cell_size) {
  cell_size_ = cell_size;
  Vector2 low = Vector2::Zero();
  Vector2 high = Vector2::Zero();
  if (!discs_.empty()) low = high = discs_.front().centre;
  for (const Disc& disc : discs_) {
    low = low.cwiseMin(disc.centre);
    high = high.cwiseMax(disc.centre);
  }
  origin_ = low;
  const Vector2 size = high - low;
  // A few far-away bodies must not cost memory: cells grow until they are few enough.
  while ((size.x() / cell_size_ + 1.0) * (size.y() / cell_size_ + 1.0) > static_cast<double>(MAX_CELLS)) {
    cell_size_ *= 2.0;
  }
  columns_ = static_cast<std::int64_t>(size.x() / cell_size_) + 1;
  rows_ = static_cast<std::int64_t>(size.y() / cell_size_) + 1;

  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  cells_.clear();
  for (const Disc& disc : discs_) {
    const auto cell = static_cast<std::uint32_t>(row(disc.centre.y()) * columns_ + column(disc.centre.x()));
    cells_.push_back(cell);
    ++first_[cell + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  sorted_.resize(discs_.size());
  // Backwards, so that each cell keeps the order of add() while first_ moves down to the cell's start.
  for (std::size_t i = discs_.size(); i-- > 0;) sorted_[--first_[cells_[i] + 1]] = discs_[i];
  // first_[c + 1] is now the start of cell c.
}

void NeighbourGrid::findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const {
  if (discs_.empty()) return;
  const double reach = distance + max_radius_;
  const std::int64_t left = column(point.x() - reach);
  const std::int64_t right = column(point.x() + reach);
  const std::int64_t top = row(point.y() + reach);
  for (std::int64_t r = row(point.y() - reach); r <= top; ++r) {
    // The cells of a row stand side by side: one run of discs.
    const auto begin = first_[static_cast<std::size_t>(r * columns_ + left) + 1];
    const auto after = static_cast<std::size_t>(r * columns_ + right) + 2;
    const auto end = after < first_.size() ? first_[after] : static_cast<std::uint32_t>(sorted_.size());
    for (std::uint32_t i = begin; i < end; ++i) {
      const double limit = distance + sorted_[i].radius;
      if (limit >= 0.0 && (sorted_[i].centre - point).squaredNorm() <= limit * limit) found.push_back(sorted_[i].body);
    }
  }
}

}  // namespace crowd
