#include "geometry/neighbour_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simd/kernels.h"

namespace crowd {
namespace {

/// Number of discs up to which a linear search with insertion sort is fastest.
constexpr std::size_t FEW_DISCS = 8;

bool isNearer(const NeighbourGrid& grid, const NearDisc& a, const NearDisc& b) {
  if (a.rim_distance != b.rim_distance) return a.rim_distance < b.rim_distance;
  return grid.body(a.disc) < grid.body(b.disc);
}

}  // namespace

Span<NearDisc> NeighbourSearch::findNearest(const NeighbourGrid& grid, const Vector2& point, double distance,
                                            std::size_t max_count, std::uint32_t except) {
  return grid.size() <= FEW_DISCS ? findInShortList(grid, point, distance, max_count, except)
                                  : findInRuns(grid, point, distance, max_count, except);
}

Span<NearDisc> NeighbourSearch::findInRuns(const NeighbourGrid& grid, const Vector2& point, double distance,
                                           std::size_t max_count, std::uint32_t except) {
  const bool all = max_count == 0;
  // 1.25 times the last radius suffices in most cases if neighbours are distributed evenly.
  double reach = all ? distance : std::min(distance, 1.25 * last_reach_);
  collect(grid, point, reach, except);
  while (!all && count_ < max_count && reach < distance) {
    reach = std::min(distance, 1.25 * reach + 0.25);
    collect(grid, point, reach, except);
  }
  const std::size_t count = count_;
  found_.resize(std::max(found_.size(), count));
  const std::size_t wanted = all ? count : std::min(count, max_count);
  if (count > simd::MAX_RANKED || !sortByRank()) sortBySelection(grid, wanted);
  if (!all) last_reach_ = count < max_count ? distance : std::max(0.0, found_[wanted - 1].rim_distance);
  return {found_.data(), wanted};
}

Span<NearDisc> NeighbourSearch::findInShortList(const NeighbourGrid& grid, const Vector2& point, double distance,
                                                std::size_t max_count, std::uint32_t except) {
  found_.resize(std::max(found_.size(), grid.size()));
  std::size_t count = 0;
  for (std::uint32_t disc = 0; disc < grid.size(); ++disc) {
    const double square = (grid.centre(disc) - point).squaredNorm();
    const double limit = distance + grid.radius(disc);
    if (square > limit * limit || grid.body(disc) == except) continue;
    const NearDisc found = {std::sqrt(square) - grid.radius(disc), disc};
    std::size_t place = count++;
    for (; place > 0 && isNearer(grid, found, found_[place - 1]); --place) found_[place] = found_[place - 1];
    found_[place] = found;
  }
  return {found_.data(), max_count == 0 ? count : std::min(count, max_count)};
}

void NeighbourSearch::collect(const NeighbourGrid& grid, const Vector2& point, double distance, std::uint32_t except) {
  const NeighbourGrid::RunsNear near = grid.findRunsNear(point, distance, runs_);
  const std::size_t capacity = near.discs + std::max(simd::DiscArrays::PADDING, simd::MAX_RANKED);
  if (discs_.size() < capacity) {
    discs_.resize(2 * capacity);
    rims_.resize(2 * capacity);
  }
  const simd::DiscArrays arrays{grid.xs(), grid.ys(), grid.radii(), grid.bodies()};
  const simd::Circle circle{point.x(), point.y(), distance, except};
  count_ = 0;
  for (const NeighbourGrid::Run& run : near.runs) {
    count_ =
        simd::kernels().collect_nearby(arrays, {run.begin, run.end}, circle, count_, {discs_.data(), rims_.data()});
  }
}

bool NeighbourSearch::sortByRank() {
  // Up to MAX_RANKED discs, comparing all pairs is faster than sorting, because no branch depends on the data.
  alignas(64) std::array<std::uint32_t, simd::MAX_RANKED> ranks;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const std::size_t count = count_;
  const std::uint32_t sum = simd::kernels().rank_ascending(rims_.data(), count, ranks.data());
  // Equal keys share a rank, so that the sum of ranks is less than 0 + 1 + ... + (count - 1).
  if (2 * std::size_t{sum} != count * (count - 1)) return false;
  for (std::size_t i = 0; i < count; ++i) found_[ranks[i]] = {rims_[i], static_cast<std::uint32_t>(discs_[i])};
  return true;
}

void NeighbourSearch::sortBySelection(const NeighbourGrid& grid, std::size_t max_count) {
  const std::size_t count = count_;
  for (std::size_t i = 0; i < count; ++i) found_[i] = {rims_[i], static_cast<std::uint32_t>(discs_[i])};
  const auto nearer = [&grid](const NearDisc& a, const NearDisc& b) { return isNearer(grid, a, b); };
  const auto end = found_.begin() + static_cast<std::ptrdiff_t>(count);
  const auto wanted = found_.begin() + static_cast<std::ptrdiff_t>(max_count);
  if (wanted != end) std::nth_element(found_.begin(), wanted, end, nearer);
  std::sort(found_.begin(), wanted, nearer);
}

}  // namespace crowd
