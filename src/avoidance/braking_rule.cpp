#include "avoidance/braking_rule.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "avoidance/escape_planner.h"
#include "avoidance/near_agents.h"
#include "simd/kernels.h"

namespace crowd {
namespace {

/// Regions that overlap by less touch each other: rounding [m].
constexpr double TOUCHING = 1e-10;

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
  const auto use_if_near = [&](const Limit& limit) {
    if (limit.max_advance < reach) use(limit);
  };
  for (std::size_t first = 0; first < seen_.neighbours.size(); first += NEIGHBOURS_AT_ONCE) {
    for (NeighbourSet left = findLimiting(first, reach); left != 0; left &= left - 1) {
      use_if_near(limitOf(seen_.neighbours[first + static_cast<std::size_t>(__builtin_ctz(left))]));
    }
  }
  for (const Segment& wall : seen_.walls) {
    use_if_near(limitOf(wall, nearestPoint(wall, Vector2::Zero()), 0.0, [](const Gap& gap) { return gap.width; }));
  }
}

/// The neighbours first .. first + NEIGHBOURS_AT_ONCE - 1 whose limit may be below a reach [m], as if all of them were
/// agents: half of the gap, less the motion of the line, is less than the reach. The gap is at least the distance
/// between the stopping regions along the line between the centres.
NeighbourSet BrakingRule::findLimiting(std::size_t first, double reach) const {
  const NeighbourSpan& all = seen_.neighbours;
  const std::size_t count = std::min(NEIGHBOURS_AT_ONCE, all.size() - first);
  const double* const xs = all.xs() + first;
  const double* const ys = all.ys() + first;
  const double* const vxs = all.vxs() + first;
  const double* const vys = all.vys() + first;
  const double* const radii = all.radii() + first;
  const Vector2 own_way = stopping_.to;
  const double tick_duration = seen_.tick_duration;
  const double near = 2.0 * reach + tick_duration * seen_.self.velocity.norm() + seen_.self.radius;
  const double per_braking = 0.5 / seen_.motion.braking;
  std::array<double, NEIGHBOURS_AT_ONCE> beyond;  // NOLINT(cppcoreguidelines-pro-type-member-init): written below
  for (std::size_t i = 0; i < NEIGHBOURS_AT_ONCE; ++i) {  // all lanes: the compiler vectorises it
    const double distance = std::sqrt(xs[i] * xs[i] + ys[i] * ys[i]);
    const double speed = std::sqrt(vxs[i] * vxs[i] + vys[i] * vys[i]);
    const double own = std::max(0.0, xs[i] * own_way.x() + ys[i] * own_way.y());
    const double its = std::max(0.0, -(xs[i] * vxs[i] + ys[i] * vys[i]) * speed * per_braking);
    beyond[i] = distance * (distance - near - tick_duration * speed - radii[i]) - own - its;
  }
  NeighbourSet limiting = 0;
  for (std::size_t i = 0; i < NEIGHBOURS_AT_ONCE; ++i) limiting |= NeighbourSet{beyond[i] <= 0.0} << i;
  limiting &= (NeighbourSet{1} << count) - 1;
  if (!all.hasObstacles()) return limiting;
  for (std::size_t i = 0; i < count; ++i) {
    if (!limits(all[first + i])) limiting &= ~(NeighbourSet{1} << i);
  }
  return limiting;
}

/// Whether agents keep out of the reach of such a body: of moving obstacles EscapePlanner keeps them away.
bool BrakingRule::limits(const Neighbour& other) {
  if (other.kind == NeighbourKind::OBSTACLE) return !isMovingObstacle(other);
  return other.kind != NeighbourKind::UNYIELDED_ROBOT;
}

BrakingRule::Limit BrakingRule::limitOf(const Neighbour& other) const {
  if (other.kind == NeighbourKind::AGENT) return limitOfAgent(other);
  // A robot may move on as it does, or stop within the tick.
  const Vector2 after = other.position + seen_.tick_duration * other.velocity;
  const auto share = [&](const Gap& gap) {
    return gap.width - (gap.is_sudden ? needOfRobot(gap.normal, seen_, other) : 0.0);
  };
  return limitOf({other.position, after}, other.position, other.radius, share);
}

BrakingRule::Limit BrakingRule::limitOfAgent(const Neighbour& other) const {
  const auto share = [&](const Gap& gap) {
    const bool moves = sharing_ == GapSharing::MOVING;
    return 0.5 * gap.width + (moves ? shiftOfLine(gap.width, gap.normal, seen_, other) : 0.0);
  };
  const Vector2 stop = other.position + seen_.motion.stoppingWay(other.velocity);
  return limitOf({other.position, stop}, other.position, other.radius, share);
}

/// @param its_way of its centre, if it brakes from now on @param share how far the agent may advance into a gap
template <typename Share>
BrakingRule::Limit BrakingRule::limitOf(const Segment& its_way, const Vector2& its_place, double its_radius,
                                        const Share& share) const {
  Gap gap = gapBetween(closestPoints(stopping_, its_way), its_radius);
  const bool is_sudden = gap.width < -TOUCHING;
  if (is_sudden) gap = gapBetween({Vector2::Zero(), its_place}, its_radius);
  gap.is_sudden = is_sudden;
  gap.width = std::max(0.0, gap.width);
  return {{gap.normal, gap.normal.dot(gap.own_point) + std::max(0.0, share(gap) - GAP_MARGIN)}, is_sudden};
}

/// Without a normal if the centres coincide: then no direction increases the overlap.
BrakingRule::Gap BrakingRule::gapBetween(const ClosestPoints& points, double other_radius) const {
  const Vector2 between = points.of_second - points.of_first;
  const double distance = between.norm();
  const Vector2 normal = distance > 0.0 ? Vector2(between / distance) : Vector2::Zero();
  return {normal, distance - seen_.self.radius - other_radius, points.of_first, false};
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
