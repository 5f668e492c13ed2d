#include "avoidance/braking_rule.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "avoidance/escape_planner.h"
#include "avoidance/near_agents.h"
#include "avoidance/stopping_gaps.h"
#include "simd/kernels.h"

namespace crowd {
namespace {

/// Limits the place where each move of a block stops.
/// @param limit of where it stops
void cutStop(const MoveLimit& limit, const Perception& seen, MoveBlock& moves) {
  const simd::StopLimit stop{limit.normal.x(), limit.normal.y(), 2.0 * seen.motion.braking * limit.max_advance,
                             seen.motion.braking * seen.tick_duration, 1.0 / seen.self.max_speed};
  simd::kernels().cut_stops(stop, moves.x.data(), moves.y.data(), MoveBlock::SIZE, moves.fraction.data());
}

}  // namespace

BrakingRule::BrakingRule(const Perception& seen, GapSharing sharing)
    : seen_(seen), sharing_(sharing), stopping_{Vector2::Zero(), seen.motion.stoppingWay(seen.self.velocity)} {}

/// Calls use(limit) for each limit below a reach [m].
template <typename Use>
void BrakingRule::forEachLimit(double reach, const Use& use) const {
  if (sharing_ == GapSharing::NONE) return;
  StoppingGaps gaps(stopping_.to, seen_.self.radius);
  const auto use_if_near = [&](const Gap& gap, double share) {
    const Limit limit{{gap.normal, gap.along + std::max(0.0, share - GAP_MARGIN)}, gap.is_sudden};
    if (limit.max_advance < reach) use(limit);
  };
  for (std::size_t first = 0; first < seen_.neighbours.size(); first += NEIGHBOURS_AT_ONCE) {
    const NeighbourSet limiting = findLimiting(first, reach);
    gaps.clear();
    for (NeighbourSet left = limiting; left != 0; left &= left - 1) {
      const Neighbour other = seen_.neighbours[first + lowestOf(left)];
      gaps.add({other.position, stopOf(other)}, other.radius);
    }
    gaps.find();
    std::size_t number = 0;
    for (NeighbourSet left = limiting; left != 0; left &= left - 1) {
      const Neighbour other = seen_.neighbours[first + lowestOf(left)];
      const Gap gap = gaps.overlaps(number) ? gapToBody(other.position, other.radius) : gapOf(gaps, number);
      use_if_near(gap, shareOf(gap, other));
      ++number;
    }
  }
  for (std::size_t first = 0; first < seen_.walls.size(); first += StoppingGaps::MAX) {
    const std::size_t count = std::min(StoppingGaps::MAX, seen_.walls.size() - first);
    gaps.clear();
    for (std::size_t i = 0; i < count; ++i) gaps.add(seen_.walls[first + i], 0.0);
    gaps.find();
    for (std::size_t i = 0; i < count; ++i) {
      const Segment& wall = seen_.walls[first + i];
      const Gap gap = gaps.overlaps(i) ? gapToBody(nearestPoint(wall, Vector2::Zero()), 0.0) : gapOf(gaps, i);
      use_if_near(gap, gap.width);
    }
  }
}

/// The neighbours first .. first + NEIGHBOURS_AT_ONCE - 1 whose limit may be below a reach [m], as if all of them were
/// agents: half of the gap, less the motion of the line, is less than the reach. The gap is at least the distance
/// between the stopping regions along the line between the centres.
NeighbourSet BrakingRule::findLimiting(std::size_t first, double reach) const {
  const NeighbourSpan& all = seen_.neighbours;
  const double room = 2.0 * reach + seen_.tick_duration * seen_.self.velocity.norm() + seen_.self.radius;
  NeighbourSet limiting = simd::kernels().find_near_stop(
      {all.xs() + first, all.ys() + first, all.vxs() + first, all.vys() + first, all.radii() + first,
       all.size() - first},
      {stopping_.to.x(), stopping_.to.y(), seen_.tick_duration, 0.5 / seen_.motion.braking, room});
  if (!all.hasObstacles()) return limiting;
  for (std::size_t i = 0; i < std::min(NEIGHBOURS_AT_ONCE, all.size() - first); ++i) {
    if (!limits(all[first + i])) limiting &= ~(NeighbourSet{1} << i);
  }
  return limiting;
}

/// Whether agents keep out of the reach of such a body: of moving obstacles EscapePlanner keeps them away.
bool BrakingRule::limits(const Neighbour& other) {
  if (other.kind == NeighbourKind::OBSTACLE) return !isMovingObstacle(other);
  return other.kind != NeighbourKind::UNYIELDED_ROBOT;
}

/// Where another body stops. A robot may move on as it does, or stop within the tick.
Vector2 BrakingRule::stopOf(const Neighbour& other) const {
  const bool is_agent = other.kind == NeighbourKind::AGENT;
  return other.position +
         (is_agent ? seen_.motion.stoppingWay(other.velocity) : Vector2(seen_.tick_duration * other.velocity));
}

BrakingRule::Gap BrakingRule::gapOf(const StoppingGaps& gaps, std::size_t number) {
  return {gaps.normal(number), std::max(0.0, gaps.width(number)), gaps.along(number), false};
}

/// @param place nearest point of the other's centre, or of a wall
BrakingRule::Gap BrakingRule::gapToBody(const Vector2& place, double its_radius) const {
  const double distance = place.norm();
  const Vector2 normal = distance > 0.0 ? Vector2(place / distance) : Vector2::Zero();
  return {normal, std::max(0.0, distance - seen_.self.radius - its_radius), 0.0, true};
}

/// How far the agent may advance into a gap to another body [m].
double BrakingRule::shareOf(const Gap& gap, const Neighbour& other) const {
  if (other.kind != NeighbourKind::AGENT) {
    return gap.width - (gap.is_sudden ? needOfRobot(gap.normal, seen_, other) : 0.0);
  }
  const bool moves = sharing_ == GapSharing::MOVING;
  return 0.5 * gap.width + (moves ? shiftOfLine(gap.width, gap.normal, seen_, other) : 0.0);
}

void BrakingRule::cut(MoveBlock* moves, std::size_t count) const {
  for (std::size_t block = 0; block < blocksOf(count); ++block) admitAll(moves[block]);
  const double step = seen_.self.max_speed * seen_.tick_duration;
  forEachLimit(seen_.motion.reach(seen_.self.max_speed, seen_.tick_duration), [&](const Limit& limit) {
    for (std::size_t block = 0; block < blocksOf(count); ++block) {
      limit.is_sudden ? cutDisplacement(limit, step, moves[block]) : cutStop(limit, seen_, moves[block]);
    }
  });
}

RelativeAction BrakingRule::actionTowards(const CandidateMove& move) const {
  return actionWith(velocityTowards(velocityOf(move)), move);
}

RelativeAction BrakingRule::actionTowards(const CandidateMove& preferred, const CandidateMove& fallback) const {
  const Vector2 velocity = reachTowards(velocityOf(preferred)).at(1.0);
  bool is_free = true;
  forEachLimit(seen_.motion.reach(velocity.norm(), seen_.tick_duration),
               [&](const Limit& limit) { is_free = is_free && isWithin(limit, velocity); });
  return is_free ? actionWith(velocity, preferred) : actionTowards(fallback);
}

RelativeAction BrakingRule::actionWith(const Vector2& velocity, const CandidateMove& move) const {
  if (velocity != Vector2::Zero()) return {bearingOf(velocity), std::min(1.0, velocity.norm() / seen_.self.max_speed)};
  if (move.fraction <= 0.0) return {0.0, 0.0};
  // It turns on the spot before it walks.
  const double most = std::min(PI, seen_.motion.turn_rate * seen_.tick_duration);
  return {std::clamp(bearingOf(move.direction), -most, most), 0.0};
}

BrakingRule::Reach BrakingRule::reachTowards(const Vector2& wanted) const {
  return {seen_.motion.reachable(seen_.self.velocity, wanted, seen_.tick_duration),
          seen_.motion.braked(seen_.self.velocity, seen_.tick_duration)};
}

Vector2 BrakingRule::velocityTowards(const Vector2& wanted) const {
  const Reach between = reachTowards(wanted);
  const double fastest = std::max(between.reached.norm(), between.braked.norm());
  const double reach = seen_.motion.reach(fastest, seen_.tick_duration);
  double share = 1.0;
  double checked_share = 0.0;
  bool is_any_sudden = false;
  while (share > 0.0 && checked_share != share) {  // a smaller share is not always within a limit that a larger one is
    checked_share = share;
    forEachLimit(reach, [&](const Limit& limit) {
      is_any_sudden = is_any_sudden || limit.is_sudden;
      while (share > 0.0 && !isWithin(limit, between.at(share))) share -= 0.25;
    });
  }
  Vector2 velocity = between.at(share);
  if (!is_any_sudden) return velocity;
  forEachLimit(reach, [&](const Limit& limit) {
    const double advance = seen_.tick_duration * limit.normal.dot(velocity);
    if (limit.is_sudden && advance > limit.max_advance) velocity *= limit.max_advance / advance;
  });
  return velocity;
}

bool BrakingRule::isWithin(const Limit& limit, const Vector2& velocity) const {
  if (limit.is_sudden) return limit.normal.dot(velocity) <= 0.0;  // else it brakes
  const Vector2 stop = seen_.tick_duration * velocity + seen_.motion.stoppingWay(velocity);
  return limit.normal.dot(stop) <= limit.max_advance;
}

}  // namespace crowd
