#include "avoidance/braking_limits.h"

#include <algorithm>

#include "avoidance/escape_planner.h"
#include "avoidance/near_agents.h"
#include "avoidance/stopping_gaps.h"
#include "simd/kernels.h"

namespace crowd {
namespace {

/// A gap between the stopping regions of the agent and of another body; if they overlap, that between the bodies.
struct Gap {
  Vector2 normal;  // towards the other; 0 if the centres coincide: then no direction increases the overlap
  double width;    // [m]
  double along;    // component along the normal of the point of the agent's way nearest to the other [m]
  bool is_sudden;  // it is that of the bodies
};

Gap gapOf(const StoppingGaps& gaps, std::size_t number) {
  return {gaps.normal(number), std::max(0.0, gaps.width(number)), gaps.along(number), false};
}

/// Finds the limits of one agent. The perception and the list must outlive it.
class LimitFinder {
 public:
  LimitFinder(const Perception& seen, GapSharing sharing, BrakingLimits& limits)
      : seen_(seen),
        sharing_(sharing),
        limits_(limits),
        stop_(seen.motion.stoppingWay(seen.self.velocity)),
        reach_(seen.motion.reach(seen.self.max_speed, seen.tick_duration)) {}

  void addThoseOfNeighbours();
  void addThoseOfWalls();

 private:
  NeighbourSet findLimiting(std::size_t first) const;
  Vector2 stopOf(const Neighbour& other) const;
  Gap gapToBody(const Vector2& place, double its_radius) const;
  double shareOf(const Gap& gap, const Neighbour& other) const;
  void addIfNear(const Gap& gap, double share);

  const Perception& seen_;
  GapSharing sharing_;
  BrakingLimits& limits_;
  Vector2 stop_;  // of the agent's centre if it brakes from now on
  double reach_;  // [m]
};

void LimitFinder::addIfNear(const Gap& gap, double share) {
  const BrakingLimit limit{{gap.normal, gap.along + std::max(0.0, share - GAP_MARGIN)}, gap.is_sudden};
  if (limit.max_advance < reach_) limits_.push_back(limit);
}

void LimitFinder::addThoseOfNeighbours() {
  StoppingGaps gaps(stop_, seen_.self.radius);
  for (std::size_t first = 0; first < seen_.neighbours.size(); first += NEIGHBOURS_AT_ONCE) {
    const NeighbourSet limiting = findLimiting(first);
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
      addIfNear(gap, shareOf(gap, other));
      ++number;
    }
  }
}

void LimitFinder::addThoseOfWalls() {
  StoppingGaps gaps(stop_, seen_.self.radius);
  for (std::size_t first = 0; first < seen_.walls.size(); first += StoppingGaps::MAX) {
    const std::size_t count = std::min(StoppingGaps::MAX, seen_.walls.size() - first);
    gaps.clear();
    for (std::size_t i = 0; i < count; ++i) gaps.add(seen_.walls[first + i], 0.0);
    gaps.find();
    for (std::size_t i = 0; i < count; ++i) {
      const Segment& wall = seen_.walls[first + i];
      const Gap gap = gaps.overlaps(i) ? gapToBody(nearestPoint(wall, Vector2::Zero()), 0.0) : gapOf(gaps, i);
      addIfNear(gap, gap.width);
    }
  }
}

/// Whether agents keep out of the reach of such a body: of moving obstacles EscapePlanner keeps them away.
bool limits(const Neighbour& other) {
  if (other.kind == NeighbourKind::OBSTACLE) return !isMovingObstacle(other);
  return other.kind != NeighbourKind::UNYIELDED_ROBOT;
}

/// The neighbours first .. first + NEIGHBOURS_AT_ONCE - 1 whose limit may be below the reach, as if all of them were
/// agents: half of the gap, less the motion of the line, is less than the reach. The gap is at least the distance
/// between the stopping regions along the line between the centres.
NeighbourSet LimitFinder::findLimiting(std::size_t first) const {
  const NeighbourSpan& all = seen_.neighbours;
  const double room = 2.0 * reach_ + seen_.tick_duration * seen_.self.velocity.norm() + seen_.self.radius;
  NeighbourSet limiting =
      simd::kernels().find_near_stop({all.xs() + first, all.ys() + first, all.vxs() + first, all.vys() + first,
                                      all.radii() + first, all.size() - first},
                                     {stop_.x(), stop_.y(), seen_.tick_duration, 0.5 / seen_.motion.braking, room});
  if (!all.hasObstacles()) return limiting;
  for (std::size_t i = 0; i < std::min(NEIGHBOURS_AT_ONCE, all.size() - first); ++i) {
    if (!limits(all[first + i])) limiting &= ~(NeighbourSet{1} << i);
  }
  return limiting;
}

/// Where another body stops. A robot may move on as it does, or stop within the tick.
Vector2 LimitFinder::stopOf(const Neighbour& other) const {
  const bool is_agent = other.kind == NeighbourKind::AGENT;
  return other.position +
         (is_agent ? seen_.motion.stoppingWay(other.velocity) : Vector2(seen_.tick_duration * other.velocity));
}

/// @param place nearest point of the other's centre, or of a wall
Gap LimitFinder::gapToBody(const Vector2& place, double its_radius) const {
  const double distance = place.norm();
  const Vector2 normal = distance > 0.0 ? Vector2(place / distance) : Vector2::Zero();
  return {normal, std::max(0.0, distance - seen_.self.radius - its_radius), 0.0, true};
}

/// How far the agent may advance into a gap to another body [m].
double LimitFinder::shareOf(const Gap& gap, const Neighbour& other) const {
  if (other.kind != NeighbourKind::AGENT) {
    return gap.width - (gap.is_sudden ? needOfRobot(gap.normal, seen_, other) : 0.0);
  }
  const bool moves = sharing_ == GapSharing::MOVING;
  return 0.5 * gap.width + (moves ? shiftOfLine(gap.width, gap.normal, seen_, other) : 0.0);
}

}  // namespace

void findBrakingLimits(const Perception& seen, GapSharing sharing, BrakingLimits& limits) {
  limits.clear();
  if (sharing == GapSharing::NONE) return;
  LimitFinder finder(seen, sharing, limits);
  finder.addThoseOfNeighbours();
  finder.addThoseOfWalls();
}

}  // namespace crowd
