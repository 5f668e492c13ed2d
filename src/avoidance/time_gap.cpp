#include "avoidance/time_gap.h"

#include <algorithm>

namespace crowd {
namespace {

constexpr double LEAST_DISTANCE = 1e-9;  // between centres [m]

/// Limits the moves of a block that have a body at `position` ahead, less than `half_width` aside.
void limit(const Vector2& position, double half_width, double max_fraction, MoveBlock& moves) {
  const double x = position.x();
  const double y = position.y();
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) {
    const double ahead = moves.x[i] * x + moves.y[i] * y;
    const double aside = moves.x[i] * y - moves.y[i] * x;
    const bool limited =
        (ahead > 0.0) & (aside < half_width) & (-aside < half_width) & (moves.fraction[i] > max_fraction);
    moves.fraction[i] = limited ? max_fraction : moves.fraction[i];
  }
}

}  // namespace

void TimeGap::cut(const Perception& perception, MoveBlock* moves, std::size_t count) const {
  if (!isOn()) return;
  for (const Neighbour& other : perception.neighbours) {
    if (other.kind != NeighbourKind::AGENT) continue;
    const double distance = other.position.norm();
    const double touching = perception.self.radius + other.radius;
    const double opening =
        other.position.dot(other.velocity - perception.self.velocity) / std::max(distance, LEAST_DISTANCE);
    const double gap = distance - touching + anticipation_time_ * std::max(0.0, opening);
    const double max_fraction = std::max(0.0, gap) / walked_;
    if (max_fraction >= 1.0) continue;
    for (std::size_t block = 0; block < blocksOf(count); ++block) {
      limit(other.position, width_ * touching, max_fraction, moves[block]);
    }
  }
}

}  // namespace crowd
