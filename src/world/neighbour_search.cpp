#include "social_crowd/world/neighbour_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numeric>

#include "social_crowd/common/vectorised.h"

namespace crowd {
namespace {

constexpr std::size_t BLOCK = NeighbourCandidates::BLOCK;
// Up to so many candidates, comparing all with all beats sorting: no branch depends on them.
constexpr std::size_t MAX_RANKED = 3 * BLOCK;

/// How many of `count` rims are smaller than each of them in single precision, by whole blocks; returns the sum.
using Rank = std::int32_t (*)(const double* rims, std::size_t count, std::int32_t* ranks);

/// Registers of so many numbers. In single precision twice as many are compared at once.
template <std::size_t LANES>
struct Registers {
  using Keys [[gnu::vector_size(LANES * sizeof(float))]] = float;
  using Ranks [[gnu::vector_size(LANES * sizeof(float))]] = std::int32_t;
};

/// A Rank for so many registers, of which the last ones may be filled in part.
template <std::size_t LANES, std::size_t COUNT>
[[gnu::always_inline]] inline std::int32_t rankRegisters(const double* __restrict rims, std::size_t count,
                                                         std::int32_t* __restrict ranks) {
  using Keys = typename Registers<LANES>::Keys;
  using Ranks = typename Registers<LANES>::Ranks;
  alignas(sizeof(Keys)) std::array<float, COUNT * LANES> keys;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = static_cast<float>(rims[i]);
  std::array<Keys, COUNT> own;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  std::memcpy(own.data(), keys.data(), sizeof(own));
  std::array<Ranks, COUNT> smaller{};
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t r = 0; r < COUNT; ++r) smaller[r] -= keys[j] < own[r];  // true is -1
  }
  std::memcpy(ranks, smaller.data(), sizeof(smaller));
  std::fill(ranks + count, ranks + keys.size(), 0);
  return std::accumulate(ranks, ranks + keys.size(), 0);
}

template <std::size_t LANES>
[[gnu::always_inline]] inline std::int32_t rankBlocks(const double* rims, std::size_t count, std::int32_t* ranks) {
  constexpr std::size_t EACH = BLOCK / LANES;
  if (count <= BLOCK) return rankRegisters<LANES, EACH>(rims, count, ranks);
  if (count <= 2 * BLOCK) return rankRegisters<LANES, 2 * EACH>(rims, count, ranks);
  return rankRegisters<LANES, 3 * EACH>(rims, count, ranks);
}

// Wider registers than a processor has would be taken apart into single numbers.
CROWD_VECTORISED std::int32_t rankAnywhere(const double* rims, std::size_t count, std::int32_t* ranks) {
  return rankBlocks<8>(rims, count, ranks);
}

#ifdef CROWD_AVX512
CROWD_AVX512 std::int32_t rankWithAvx512(const double* rims, std::size_t count, std::int32_t* ranks) {
  return rankBlocks<16>(rims, count, ranks);
}
#endif

Rank fastestRank() { return CROWD_FASTEST(rankWithAvx512, rankAnywhere); }

bool isNearer(const NeighbourGrid& grid, const NearDisc& a, const NearDisc& b) {
  if (a.rim_distance != b.rim_distance) return a.rim_distance < b.rim_distance;
  return grid.body(a.disc) < grid.body(b.disc);
}

}  // namespace

View<NearDisc> NeighbourSearch::findNearest(const NeighbourGrid& grid, const Vector2& point, double distance,
                                            std::size_t most, std::uint32_t except) {
  return grid.isShort() ? findInShortList(grid, point, distance, most, except)
                        : findInRuns(grid, point, distance, most, except);
}

View<NearDisc> NeighbourSearch::findInRuns(const NeighbourGrid& grid, const Vector2& point, double distance,
                                           std::size_t most, std::uint32_t except) {
  const bool all = most == 0;
  // A quarter more than last time: with neighbours spread evenly that is enough more often than not.
  double reach = all ? distance : std::min(distance, 1.25 * last_reach_);
  gather(grid, point, reach, except);
  while (!all && candidates_.count < most && reach < distance) {
    reach = std::min(distance, 1.25 * reach + 0.25);
    gather(grid, point, reach, except);
  }
  const std::size_t count = candidates_.count;
  candidates_.findRims();
  found_.resize(std::max(found_.size(), count));
  const std::size_t wanted = all ? count : std::min(count, most);
  if (count > MAX_RANKED || !sortByRank()) sortBySelection(grid, wanted);
  if (!all) last_reach_ = count < most ? distance : std::max(0.0, found_[wanted - 1].rim_distance);
  return {found_.data(), wanted};
}

View<NearDisc> NeighbourSearch::findInShortList(const NeighbourGrid& grid, const Vector2& point, double distance,
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
  const NeighbourGrid::RunsNear near = grid.findRunsNear(point, distance, runs_);
  candidates_.makeRoom(near.discs);
  collect_(grid, near.runs, point, distance, except, candidates_);
}

bool NeighbourSearch::sortByRank() {
  const std::size_t count = candidates_.count;
  static const Rank RANK = fastestRank();
  alignas(64) std::array<std::int32_t, MAX_RANKED> ranks;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  const std::int32_t sum = RANK(candidates_.rims.data(), count, ranks.data());
  // Equal keys share a rank, so that the ranks add up to less than 0 + 1 + ... + (count - 1).
  if (2 * static_cast<std::size_t>(sum) != count * (count - 1)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    found_[static_cast<std::size_t>(ranks[i])] = {candidates_.rims[i], candidates_.discs[i]};
  }
  return true;
}

void NeighbourSearch::sortBySelection(const NeighbourGrid& grid, std::size_t most) {
  const std::size_t count = candidates_.count;
  for (std::size_t i = 0; i < count; ++i) found_[i] = {candidates_.rims[i], candidates_.discs[i]};
  const auto nearer = [&grid](const NearDisc& a, const NearDisc& b) { return isNearer(grid, a, b); };
  const auto end = found_.begin() + static_cast<std::ptrdiff_t>(count);
  const auto wanted = found_.begin() + static_cast<std::ptrdiff_t>(most);
  if (wanted != end) std::nth_element(found_.begin(), wanted, end, nearer);
  std::sort(found_.begin(), wanted, nearer);
}

}  // namespace crowd
