#include "avoidance/time_gap.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr double LEAST_DISTANCE = 1e-9;  // between centres [m]

/// Another agent that limits moves.
struct Leader {
  Vector2 position;   // [m]
  double distance;    // of it [m]
  double half_width;  // of moves that it limits [m]
  double now;         // admissible fraction at the present gap
  double later_gap;   // after the anticipation time, if the agent stood [m]
  double own_way;     // of the agent at full speed in the anticipation time [m]
};

/// Limits the moves of a block that have a leader ahead. @param walked at full speed in the time gap [m]
void limit(const Leader& leader, double walked, MoveBlock& moves) {
  const double x = leader.position.x();
  const double y = leader.position.y();
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) {
    const double ahead = moves.x[i] * x + moves.y[i] * y;
    const double aside = moves.x[i] * y - moves.y[i] * x;
    // At the fraction f the gap is later_gap - f * own_way * cosine after the anticipation time, and has to be f *
    // walked.
    const double cosine = std::max(0.0, ahead) / leader.distance;
    const double most = std::max(leader.now, leader.later_gap / (walked + leader.own_way * cosine));
    const bool limited =
        (ahead > 0.0) & (aside < leader.half_width) & (-aside < leader.half_width) & (moves.fraction[i] > most);
    moves.fraction[i] = limited ? most : moves.fraction[i];
  }
}

}  // namespace

void TimeGap::cut(const Perception& perception, MoveBlock* moves, std::size_t count) const {
  if (!isOn()) return;
  const AgentPerception& self = perception.self;
  for (const Neighbour& other : perception.neighbours) {
    if (other.kind != NeighbourKind::AGENT) continue;
    const double distance = std::max(other.position.norm(), LEAST_DISTANCE);
    const double touching = self.radius + other.radius;
    const double gap = std::max(0.0, distance - touching);
    const double now = gap / walked_;
    if (now >= 1.0) continue;
    const double later_gap = gap + anticipation_time_ * other.position.dot(other.velocity) / distance;
    const Leader leader{
        other.position, distance, width_ * touching, now, later_gap, anticipation_time_ * self.max_speed};
    for (std::size_t block = 0; block < blocksOf(count); ++block) limit(leader, walked_, moves[block]);
  }
}

}  // namespace crowd
