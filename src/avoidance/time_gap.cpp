#include "avoidance/time_gap.h"

#include <algorithm>

namespace crowd {
namespace {

/// Another agent that limits moves.
struct Leader {
  Vector2 position;   // [m]
  double half_width;  // of moves that it limits [m]
};

/// Limits those of the first `count` moves that have a leader ahead.
/// @param admissible returns the admissible fraction of a move; its argument is the component of the move towards the
/// leader, times the distance of the leader [m]
template <typename Admissible>
void limit(const Leader& leader, const Admissible& admissible, MoveBlock* moves, std::size_t count) {
  const double x = leader.position.x();
  const double y = leader.position.y();
  for (MoveBlock* block = moves; block != moves + blocksOf(count); ++block) {
    for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) {
      const double ahead = block->x[i] * x + block->y[i] * y;
      const double aside = block->x[i] * y - block->y[i] * x;
      const double most = admissible(ahead);
      const bool limited =
          (ahead > 0.0) & (aside < leader.half_width) & (-aside < leader.half_width) & (block->fraction[i] > most);
      block->fraction[i] = limited ? most : block->fraction[i];
    }
  }
}

}  // namespace

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
    const Leader leader{other.position, width_ * touching};
    const double opening = anticipation_time_ * other.position.dot(other.velocity);  // times the distance [m2]
    if (opening <= 0.0) {
      const auto admissible = [now](double) { return now; };
      limit(leader, admissible, moves, count);
    } else {
      // At the fraction f the gap is later_gap - f * own_way * cosine after the anticipation time, and has to be f *
      // walked.
      const double later_gap = gap + opening / distance;
      const auto admissible = [&](double ahead) {
        const double cosine = std::max(0.0, ahead) / distance;
        return std::max(now, later_gap / (walked_ + own_way * cosine));
      };
      limit(leader, admissible, moves, count);
    }
  }
}

}  // namespace crowd
