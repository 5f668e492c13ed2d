#include "avoidance/near_agents.h"

#include "simd/kernels.h"

namespace crowd {
namespace {

/// Upper bound of the rounding error of a distance [m].
constexpr double ROUNDING = 1e-6;

/// Distance below which the separation rule may limit a move [m]. It is compared with the distance between the centres,
/// less the other's radius and the approach of the line between both.
inline double nearDistanceOf(const Perception& seen) {
  const double reach = seen.self.max_speed * seen.tick_duration;
  return seen.self.radius + 2.0 * (reach + GAP_MARGIN) + ROUNDING;
}

}  // namespace

NeighbourSet findNear(const Perception& seen, std::size_t first) {
  // A limit has no effect if half of the gap, less the approach of the line between both agents, is longer than the
  // longest displacement.
  static_assert(NEIGHBOURS_AT_ONCE == simd::MAX_LOOKED_AT, "as many as the kernel examines");
  const NeighbourSpan& neighbours = seen.neighbours;
  const Vector2& velocity = seen.self.velocity;
  return simd::kernels().find_near({neighbours.xs() + first, neighbours.ys() + first, neighbours.vxs() + first,
                                    neighbours.vys() + first, neighbours.radii() + first, neighbours.size() - first},
                                   {velocity.x(), velocity.y(), seen.tick_duration, nearDistanceOf(seen)});
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): only the first count_ entries are read
NearAgents::NearAgents(const PerceptionBatch& batch) {
  for (std::uint32_t k = 0; k < batch.size(); ++k) {
    const Perception& seen = batch[k];
    if (!isFor(seen)) continue;
    for (NeighbourSet left = findNear(seen, 0); left != 0; left &= left - 1) {
      list_[count_++] = {k * static_cast<std::uint32_t>(NEIGHBOURS_AT_ONCE) +
                         static_cast<std::uint32_t>(lowestOf(left))};
    }
  }
}

}  // namespace crowd
