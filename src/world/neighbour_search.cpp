#include "social_crowd/world/neighbour_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "social_crowd/common/vectorised.h"

namespace crowd {
namespace {

// Up to so many candidates, comparing all with all beats sorting: no branch depends on them.
constexpr std::size_t MAX_RANKED = 48;
constexpr std::size_t LANES = 8;

// In single precision twice as many are compared at once.
using Keys = float __attribute__((vector_size(LANES * sizeof(float))));
using Ranks = std::int32_t __attribute__((vector_size(LANES * sizeof(float))));

/// Squared distances of discs from a point, and which (1, else 0) have their rim within the distance.
CROWD_VECTORISED void measureDiscs(const NeighbourGrid& grid, const NeighbourGrid::Runs& runs, const Vector2& point,
                                   double distance, double* __restrict squares, std::int64_t* __restrict near) {
  const double x = point.x();
  const double y = point.y();
  for (const NeighbourGrid::Run& run : runs) {
    const double* __restrict xs = grid.xs() + run.begin;
    const double* __restrict ys = grid.ys() + run.begin;
    const double* __restrict radii = grid.radii() + run.begin;
    const std::size_t count = run.end - run.begin;
    for (std::size_t i = 0; i < count; ++i) {
      const double dx = xs[i] - x;
      const double dy = ys[i] - y;
      const double limit = distance + radii[i];
      squares[i] = dx * dx + dy * dy;
      near[i] = squares[i] <= limit * limit ? 1 : 0;
    }
    squares += count;
    near += count;
  }
}

/// From squared distances of centres to distances of rims.
CROWD_VECTORISED void findRims(const double* __restrict radii, std::size_t count, double* __restrict distances) {
  for (std::size_t i = 0; i < count; ++i) distances[i] = std::sqrt(distances[i]) - radii[i];
}

/// How many of `count` keys are smaller than each of them. The keys are filled up with the highest to full lanes.
CROWD_VECTORISED void rank(const float* __restrict keys, std::size_t count, std::int32_t* __restrict ranks) {
  for (std::size_t block = 0; block < count; block += LANES) {
    Keys own;
    std::memcpy(&own, keys + block, sizeof(own));
    Ranks smaller{};
    for (std::size_t j = 0; j < count; ++j) smaller -= keys[j] < own;
    std::memcpy(ranks + block, &smaller, sizeof(smaller));
  }
}

bool isNearer(const NeighbourGrid& grid, const NearDisc& a, const NearDisc& b) {
  if (a.rim_distance != b.rim_distance) return a.rim_distance < b.rim_distance;
  return grid.body(a.disc) < grid.body(b.disc);
}

}  // namespace

View<NearDisc> NeighbourSearch::findNearest(const NeighbourGrid& grid, const Vector2& point, double distance,
                                            std::size_t most, std::uint32_t except) {
  if (grid.isList()) return findInList(grid, point, distance, most, except);
  const bool all = most == 0;
  // A quarter more than last time: with neighbours spread evenly that is enough more often than not.
  double reach = all ? distance : std::min(distance, 1.25 * last_reach_);
  gather(grid, point, reach, except);
  while (!all && count_ < most && reach < distance) {
    reach = std::min(distance, 1.5 * reach + 0.5);
    gather(grid, point, reach, except);
  }
  const std::size_t wanted = all ? count_ : std::min(count_, most);
  if (count_ > MAX_RANKED || !sortByRank()) sortBySelection(grid, wanted);
  if (!all) last_reach_ = count_ < most ? distance : std::max(0.0, found_[wanted - 1].rim_distance);
  return {found_.data(), wanted};
}

View<NearDisc> NeighbourSearch::findInList(const NeighbourGrid& grid, const Vector2& point, double distance,
                                           std::size_t most, std::uint32_t except) {
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
  return {found_.data(), most == 0 ? count : std::min(count, most)};
}

void NeighbourSearch::gather(const NeighbourGrid& grid, const Vector2& point, double distance, std::uint32_t except) {
  grid.findRunsNear(point, distance, runs_);
  std::size_t count = 0;
  for (const NeighbourGrid::Run& run : runs_) count += run.end - run.begin;
  if (squares_.size() < count) {
    squares_.resize(2 * count);
    near_.resize(2 * count);
    for (auto* list : {&radii_, &rims_}) list->resize(2 * count);
    discs_.resize(2 * count);
    found_.resize(2 * count);
  }
  measureDiscs(grid, runs_, point, distance, squares_.data(), near_.data());
  count_ = 0;
  std::size_t next = 0;
  for (const NeighbourGrid::Run& run : runs_) {
    for (std::uint32_t i = run.begin; i < run.end; ++i, ++next) {
      // Written in any case and kept by counting on: a branch would be guessed wrong half of the time.
      discs_[count_] = i;
      radii_[count_] = grid.radius(i);
      rims_[count_] = squares_[next];
      count_ += static_cast<std::size_t>(near_[next]) & static_cast<std::size_t>(grid.body(i) != except);
    }
  }
  findRims(radii_.data(), count_, rims_.data());
}

bool NeighbourSearch::sortByRank() {
  if (count_ == 1) found_[0] = {rims_[0], discs_[0]};
  if (count_ <= 1) return true;
  alignas(32) std::array<float, MAX_RANKED> keys;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  alignas(32) std::array<std::int32_t, MAX_RANKED> ranks;  // NOLINT(cppcoreguidelines-pro-type-member-init): by rank()
  keys.fill(std::numeric_limits<float>::infinity());
  for (std::size_t i = 0; i < count_; ++i) keys[i] = static_cast<float>(rims_[i]);
  rank(keys.data(), count_, ranks.data());
  std::size_t sum = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const auto place = static_cast<std::size_t>(ranks[i]);
    found_[place] = {rims_[i], discs_[i]};
    sum += place;
  }
  // Equal keys share a rank, so that the ranks add up to less than 0 + 1 + ... + (count - 1).
  return 2 * sum == count_ * (count_ - 1);
}

void NeighbourSearch::sortBySelection(const NeighbourGrid& grid, std::size_t most) {
  for (std::size_t i = 0; i < count_; ++i) found_[i] = {rims_[i], discs_[i]};
  const auto nearer = [&grid](const NearDisc& a, const NearDisc& b) { return isNearer(grid, a, b); };
  const auto end = found_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto wanted = found_.begin() + static_cast<std::ptrdiff_t>(most);
  if (wanted != end) std::nth_element(found_.begin(), wanted, end, nearer);
  std::sort(found_.begin(), wanted, nearer);
}

}  // namespace crowd
