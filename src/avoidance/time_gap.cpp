#include "avoidance/time_gap.h"

#include <algorithm>

#include "simd/kernels.h"

namespace crowd {

void TimeGap::cut(const Perception& perception, MoveBlock* moves, std::size_t count) const {
  if (!isOn()) return;
  const AgentPerception& self = perception.self;
  const double own_way = anticipation_time_ * self.max_speed;  // at full speed [m]
  for (const Neighbour& other : perception.neighbours) {
    if (other.kind != NeighbourKind::AGENT) continue;
    const double distance = other.position.norm();
    const double touching = self.radius + other.radius;
    const double gap = std::max(0.0, distance - touching);
    const double now = gap / walked_;
    if (now >= 1.0) continue;
    const double opening = anticipation_time_ * other.position.dot(other.velocity);  // times the distance [m2]
    const double later_gap = opening > 0.0 ? gap + opening / distance : 0.0;
    const simd::Leader leader{
        other.position.x(), other.position.y(), distance, width_ * touching, now, later_gap, walked_, own_way};
    for (MoveBlock* block = moves; block != moves + blocksOf(count); ++block) {
      simd::kernels().cut_following(leader, block->x.data(), block->y.data(), MoveBlock::SIZE, block->fraction.data());
    }
  }
}

}  // namespace crowd
