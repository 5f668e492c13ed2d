#include "geometry/neighbour_grid.h"

#include <algorithm>

#include "simd/kernels.h"

namespace crowd {

static_assert(NeighbourGrid::PADDING >= simd::DiscArrays::PADDING, "kernels read beyond the last disc");

void NeighbourGrid::clear() {
  added_.clear();
  motions_.clear();
  max_radius_ = 0.0;
}

void NeighbourGrid::add(const Vector2& centre, double radius, std::uint32_t body, const Vector2& velocity) {
  added_.push_back({centre, radius, body, velocity});
  max_radius_ = std::max(max_radius_, radius);
}

void NeighbourGrid::build(double cell_size) {
  for (auto* numbers : {&xs_, &ys_, &radii_}) numbers->resize(added_.size() + PADDING);
  bodies_.resize(added_.size() + PADDING);
  motions_.resize(added_.size());
  cell_size_ = cell_size;
  if (!isList()) return sortIntoCells();
  for (std::size_t i = 0; i < added_.size(); ++i) place(added_[i], i);
}

void NeighbourGrid::sortIntoCells() {
  layOut();
  countCells();
  // first_[c + 1] is the start of cell c, and advances to its end while the cell is filled in the order of add().
  for (std::size_t i = 0; i < added_.size(); ++i) place(added_[i], first_[cells_[i] + 1]++);
}

void NeighbourGrid::layOut() {
  Vector2 low = added_.front().centre;
  Vector2 high = low;
  for (const Disc& disc : added_) {
    low = low.cwiseMin(disc.centre);
    high = high.cwiseMax(disc.centre);
  }
  origin_ = low;
  cells_per_metre_ = 1.0 / cell_size_;
  const Vector2 size = high - low;
  // Distant bodies must not increase memory use: the cell size is doubled until MAX_CELLS suffice.
  while ((size.x() * cells_per_metre_ + 1.0) * (size.y() * cells_per_metre_ + 1.0) > static_cast<double>(MAX_CELLS)) {
    cells_per_metre_ /= 2.0;
  }
  columns_ = static_cast<std::int64_t>(size.x() * cells_per_metre_) + 1;
  rows_ = static_cast<std::int64_t>(size.y() * cells_per_metre_) + 1;
}

void NeighbourGrid::countCells() {
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 2, 0);
  cells_.clear();
  for (const Disc& disc : added_) {
    const auto cell = static_cast<std::uint32_t>(row(disc.centre.y()) * columns_ + column(disc.centre.x()));
    cells_.push_back(cell);
    ++first_[cell + 2];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
}

void NeighbourGrid::place(const Disc& disc, std::size_t where) {
  setMotion(where, disc);
  radii_[where] = disc.radius;
  bodies_[where] = disc.body;
}

NeighbourGrid::RunsNear NeighbourGrid::findRunsNear(const Vector2& point, double distance, Runs& space) const {
  if (isList()) {
    if (space.empty()) space.resize(1);
    space[0] = all();
    return {{space.data(), 1}, size()};
  }
  const Cells cells = cellsNear(point, distance);
  const auto count = static_cast<std::size_t>(cells.top - cells.bottom + 1);
  if (space.size() < count) space.resize(2 * count);
  std::size_t discs = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Run run = runOf(cells, cells.bottom + static_cast<std::int64_t>(i));
    space[i] = run;
    discs += run.end - run.begin;
  }
  return {{space.data(), count}, discs};
}

void NeighbourGrid::findNear(const Vector2& point, double distance, std::vector<std::uint32_t>& found) const {
  const auto search = [&](const Run& run) {
    for (std::uint32_t i = run.begin; i < run.end; ++i) {
      const double limit = distance + radii_[i];
      if (limit >= 0.0 && (centre(i) - point).squaredNorm() <= limit * limit) found.push_back(bodies_[i]);
    }
  };
  if (isList()) return search(all());
  const Cells cells = cellsNear(point, distance);
  for (std::int64_t r = cells.bottom; r <= cells.top; ++r) search(runOf(cells, r));
}

bool NeighbourGrid::isAnyInRuns(const Vector2& point, double distance, std::uint32_t except) const {
  const simd::DiscArrays arrays{xs(), ys(), radii(), bodies()};
  const simd::Circle circle{point.x(), point.y(), distance, except};
  simd::IsAnyNearby* const is_any_nearby = simd::kernels().is_any_nearby;
  if (isList()) return is_any_nearby(arrays, {0, all().end}, circle);
  const Cells cells = cellsNear(point, distance);
  const auto search = [&](std::int64_t row) {
    const Run run = runOf(cells, row);
    return is_any_nearby(arrays, {run.begin, run.end}, circle);
  };
  // Nearly always one or two rows. Both are always searched, because a branch would be mispredicted half of the time.
  const bool at_bottom = search(cells.bottom);
  bool any = search(cells.top) || at_bottom;
  for (std::int64_t r = cells.bottom + 1; r < cells.top && !any; ++r) any = search(r);
  return any;
}

}  // namespace crowd
