#include "avoidance/time_gap.h"

#include <algorithm>

namespace crowd {
namespace {

/// Another agent that limits moves.
struct Leader {
  Vector2 position;   // [m]
  double half_width;  // of moves that it limits [m]
};

/// Limits the moves of a block that have a leader ahead.
/// @param admissible returns the admissible fraction of a move; its argument is the component of the move towards the
/// leader, times the distance of the leader [m]
template <typename Admissible>
void limit(const Leader& leader, const Admissible& admissible, MoveBlock& moves) {
  const double x = leader.position.x();
  const double y = leader.position.y();
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) {
    const double ahead = moves.x[i] * x + moves.y[i] * y;
    const double aside = moves.x[i] * y - moves.y[i] * x;
    const double most = admissible(ahead);
    const bool limited =
        (ahead > 0.0) & (aside < leader.half_width) & (-aside < leader.half_width) & (moves.fraction[i] > most);
    moves.fraction[i] = limited ? most : moves.fraction[i];
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
    for (std::size_t block = 0; block < blocksOf(count); ++block) {
      if (opening <= 0.0) {
        limit(
            leader, [now](double) { return now; }, moves[block]);
      } else {
        // At the fraction f the gap is later_gap - f * own_way * cosine after the anticipation time, and has to be f *
        // walked.
        const double later_gap = gap + opening / distance;
        const auto later = [=](double ahead) {
          return later_gap / (walked_ + own_way * (std::max(0.0, ahead) / distance));
        };
        limit(
            leader, [=](double ahead) { return std::max(now, later(ahead)); }, moves[block]);
      }
    }
  }
}

}  // namespace crowd
