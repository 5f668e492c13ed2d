#include "social_crowd/world/neighbour_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crowd {
namespace {

// Up to so many candidates, comparing all with all beats sorting: no branch depends on them.
constexpr std::size_t MAX_RANKED = 48;

}  // namespace

View<NearDisc> NeighbourSearch::findNearest(const NeighbourGrid& grid, const Vector2& point, double distance,
                                            std::size_t most, std::uint32_t except) {
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

void NeighbourSearch::gather(const NeighbourGrid& grid, const Vector2& point, double distance, std::uint32_t except) {
  count_ = 0;
  grid.forRunsNear(point, distance, [&](std::uint32_t begin, std::uint32_t end) {
    if (discs_.size() < count_ + (end - begin)) discs_.resize(2 * (count_ + (end - begin)));
    for (std::uint32_t i = begin; i < end; ++i) {
      const double limit = distance + grid.radius(i);
      const bool near = (grid.centre(i) - point).squaredNorm() <= limit * limit;
      // Written in any case and kept by counting on: a branch would be guessed wrong half of the time.
      discs_[count_] = i;
      count_ += static_cast<std::size_t>(near & (limit >= 0.0) & (grid.body(i) != except));
    }
  });
  if (rims_.size() < count_) rims_.resize(discs_.size());
  if (found_.size() < count_) found_.resize(discs_.size());
  for (std::size_t i = 0; i < count_; ++i) {
    rims_[i] = (grid.centre(discs_[i]) - point).norm() - grid.radius(discs_[i]);
  }
}

bool NeighbourSearch::sortByRank() {
  std::array<float, MAX_RANKED> keys{};  // in single precision twice as many are compared at once
  for (std::size_t i = 0; i < count_; ++i) keys[i] = static_cast<float>(rims_[i]);
  std::uint32_t sum = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const float key = keys[i];
    std::uint32_t rank = 0;
    for (std::size_t j = 0; j < count_; ++j) rank += static_cast<std::uint32_t>(keys[j] < key);
    found_[rank] = {rims_[i], discs_[i]};
    sum += rank;
  }
  // Equal keys share a rank, so that the ranks add up to less than 0 + 1 + ... + (count - 1).
  return 2 * sum == count_ * (count_ - 1);
}

void NeighbourSearch::sortBySelection(const NeighbourGrid& grid, std::size_t most) {
  for (std::size_t i = 0; i < count_; ++i) found_[i] = {rims_[i], discs_[i]};
  const auto nearer = [&grid](const NearDisc& a, const NearDisc& b) {
    return a.rim_distance < b.rim_distance ||
           (a.rim_distance == b.rim_distance && grid.body(a.disc) < grid.body(b.disc));
  };
  const auto end = found_.begin() + static_cast<std::ptrdiff_t>(count_);
  const auto wanted = found_.begin() + static_cast<std::ptrdiff_t>(most);
  if (wanted != end) std::nth_element(found_.begin(), wanted, end, nearer);
  std::sort(found_.begin(), wanted, nearer);
}

}  // namespace crowd
