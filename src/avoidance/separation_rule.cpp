#include "avoidance/separation_rule.h"

#include <algorithm>
#include <array>

#include "avoidance/braking_rule.h"
#include "avoidance/comfort.h"
#include "avoidance/escape_planner.h"
#include "avoidance/move_limit.h"
#include "avoidance/near_agents.h"
#include "geometry/impact.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

inline MoveLimit limitOf(const Vector2& towards, double distance, double max_advance) {
  // The centres coincide: no direction increases the overlap, so no move is limited.
  if (distance <= 0.0) return {Vector2::Zero(), 0.0};
  return {towards / distance, max_advance - GAP_MARGIN};
}

inline MoveLimit limitOfAgent(const Perception& seen, const Neighbour& other, GapSharing sharing) {
  const double distance = other.position.norm();
  const double gap = std::max(0.0, distance - seen.self.radius - other.radius);
  MoveLimit limit = limitOf(other.position, distance, 0.5 * gap);
  if (sharing == GapSharing::MOVING) limit.max_advance += shiftOfLine(gap, limit.normal, seen, other);
  limit.max_advance = std::max(0.0, limit.max_advance);
  return limit;
}

MoveLimit limitOfObstacle(const AgentPerception& self, const Neighbour& other) {
  const double distance = other.position.norm();
  MoveLimit limit = limitOf(other.position, distance, distance - self.radius - other.radius);
  limit.max_advance = std::max(0.0, limit.max_advance);
  return limit;
}

MoveLimit limitOfRobot(const Perception& seen, const Neighbour& robot) {
  const double distance = robot.position.norm();
  MoveLimit limit = limitOf(robot.position, distance, distance - seen.self.radius - robot.radius);
  limit.max_advance = std::max(0.0, limit.max_advance - needOfRobot(limit.normal, seen, robot));
  return limit;
}

MoveLimit limitOf(const Perception& seen, const Neighbour& neighbour, GapSharing sharing) {
  switch (neighbour.kind) {
    case NeighbourKind::AGENT:
      return limitOfAgent(seen, neighbour, sharing);
    case NeighbourKind::ROBOT:
      return limitOfRobot(seen, neighbour);
    default:
      return limitOfObstacle(seen.self, neighbour);
  }
}

/// Excludes moves into the way of a robot, such as a step sideways in front of one that would pass otherwise: moves
/// that touch a perceived robot, which keeps its velocity, within the tick, unless it reaches the agent anyway.
void keepOutOfReach(const Perception& seen, MoveBlock* moves, std::size_t count) {
  const double step = seen.self.max_speed * seen.tick_duration;
  for (const Neighbour& robot : seen.neighbours) {
    if (robot.kind != NeighbourKind::ROBOT) continue;
    const double reach = seen.self.radius + robot.radius;
    const Vector2 way = seen.tick_duration * robot.velocity;
    if (robot.position.norm() - reach > step + way.norm()) continue;
    if (firstTouch(robot.position, Vector2(-way), reach, 1.0) < NO_IMPACT) continue;
    for (std::size_t i = 0; i < blocksOf(count) * MoveBlock::SIZE; ++i) {
      CandidateMove move = moveAt(moves, i);
      const Vector2 relative = move.fraction * step * move.direction - way;
      if (firstTouch(robot.position, relative, reach, 1.0) == NO_IMPACT) continue;
      move.fraction = 0.0;
      setMove(moves, i, move);
    }
  }
}

MoveLimit limitOfWall(const AgentPerception& self, const Segment& wall) {
  const Vector2 nearest = nearestPoint(wall, Vector2::Zero());
  const double distance = nearest.norm();
  MoveLimit limit = limitOf(nearest, distance, distance - self.radius);
  limit.max_advance = std::max(0.0, limit.max_advance);
  return limit;
}

void admitAll(MoveBlock* moves, std::size_t count) {
  for (std::size_t block = 0; block < blocksOf(count); ++block) admitAll(moves[block]);
}

void cutToGap(const MoveLimit& limit, double reach, MoveBlock* moves, std::size_t count) {
  if (limit.max_advance >= reach) return;
  for (std::size_t block = 0; block < blocksOf(count); ++block) cutDisplacement(limit, reach, moves[block]);
}

void cutToWalls(const Perception& seen, MoveBlock* moves, std::size_t count) {
  const double reach = seen.self.max_speed * seen.tick_duration;
  for (const Segment& wall : seen.walls) cutToGap(limitOfWall(seen.self, wall), reach, moves, count);
}

/// A limit and the moves that it applies to.
struct Cut {  // NOLINT(cppcoreguidelines-pro-type-member-init): as MoveLimit
  MoveLimit limit;
  double reach;  // the longest displacement of a tick [m]
  MoveBlock* moves;
};

/// The neighbours first .. first + NEIGHBOURS_AT_ONCE - 1 that may limit a move: near agents, all static obstacles, and
/// all robots that agents yield to.
NeighbourSet findLimiting(const Perception& seen, std::size_t first) {
  NeighbourSet limiting = findNear(seen, first);
  if (!seen.neighbours.hasObstacles()) return limiting;
  const std::size_t count = std::min(NEIGHBOURS_AT_ONCE, seen.neighbours.size() - first);
  for (std::size_t i = 0; i < count; ++i) {
    const Neighbour neighbour = seen.neighbours[first + i];
    if (neighbour.kind == NeighbourKind::AGENT) continue;
    const bool stands = neighbour.kind == NeighbourKind::OBSTACLE && !isMovingObstacle(neighbour);
    const bool limits = stands || neighbour.kind == NeighbourKind::ROBOT;
    limiting = limits ? limiting | NeighbourSet{1} << i : limiting & ~(NeighbourSet{1} << i);
  }
  return limiting;
}

}  // namespace

void SeparationRule::cut(const PerceptionBatch& batch, MoveBlock* moves, std::size_t count,
                         BrakingLimits* limits) const {
  if (batch.size() > 0 && batch[0].motion.areOn()) {
    for (std::size_t k = 0; k < batch.size(); ++k) cut(batch[k], moves + k * blocksOf(count), count, limits[k]);
    return;
  }
  for (std::size_t k = 0; k < batch.size(); ++k) {
    MoveBlock* const own = moves + k * blocksOf(count);
    if (NearAgents::isFor(batch[k])) {
      admitAll(own, count);
    } else {
      cut(batch[k], own, count, limits[k]);
    }
  }
  if (sharing_ == GapSharing::NONE) return;
  cutAmongAgents(batch, moves, count);
  for (std::size_t k = 0; k < batch.size(); ++k) {
    if (NearAgents::isFor(batch[k])) cutToWalls(batch[k], moves + k * blocksOf(count), count);
  }
}

/// Collects the limits of all agents in one list before it applies them: loops over the limits of each agent would be
/// short and of unpredictable length, so that branches would be mispredicted.
void SeparationRule::cutAmongAgents(const PerceptionBatch& batch, MoveBlock* moves, std::size_t count) const {
  std::array<Cut, NearAgents::MAX_COUNT> cuts;  // NOLINT(cppcoreguidelines-pro-type-member-init): `cut_count` are valid
  std::size_t cut_count = 0;
  for (const NearAgent near : NearAgents(batch)) {
    const Perception& seen = batch[near.agent()];
    const double reach = seen.self.max_speed * seen.tick_duration;
    const MoveLimit limit = limitOfAgent(seen, seen.neighbours[near.neighbour()], sharing_);
    cuts[cut_count] = {limit, reach, moves + near.agent() * blocksOf(count)};
    cut_count += limit.max_advance < reach ? 1 : 0;  // the others are overwritten
  }
  for (std::size_t i = 0; i < cut_count; ++i) cutToGap(cuts[i].limit, cuts[i].reach, cuts[i].moves, count);
}

void SeparationRule::cut(const Perception& perception, MoveBlock* moves, std::size_t count,
                         BrakingLimits& limits) const {
  if (perception.motion.areOn()) findBrakingLimits(perception, sharing_, limits);
  cutToGaps(perception, moves, count, limits);
  if (!perception.neighbours.hasObstacles() || sharing_ == GapSharing::NONE) return;
  cutToComfort(perception, moves, count);
  if (lookout_ > 0.0) replaceUnsafe(perception, moves, count, limits);
  keepOutOfReach(perception, moves, count);
}

void SeparationRule::replaceUnsafe(const Perception& perception, MoveBlock* moves, std::size_t count,
                                   const BrakingLimits& limits) const {
  EscapePlanner escape_planner(perception, lookout_);
  if (!escape_planner.isNeeded()) return;
  cutToGaps(perception, escape_planner.straightMoves(), escape_planner.straightMoveCount(), limits);
  escape_planner.replaceUnsafe(moves, count);
}

bool SeparationRule::mustEscape(const Perception& perception) const {
  if (!perception.neighbours.hasObstacles() || sharing_ == GapSharing::NONE || lookout_ <= 0.0) return false;
  return EscapePlanner(perception, lookout_).isNeeded();
}

void SeparationRule::cutToGaps(const Perception& perception, MoveBlock* moves, std::size_t count,
                               const BrakingLimits& limits) const {
  if (perception.motion.areOn()) return BrakingRule(perception, limits).cut(moves, count);
  admitAll(moves, count);
  if (sharing_ == GapSharing::NONE) return;
  const AgentPerception& self = perception.self;
  const double reach = self.max_speed * perception.tick_duration;
  for (std::size_t first = 0; first < perception.neighbours.size(); first += NEIGHBOURS_AT_ONCE) {
    for (NeighbourSet left = findLimiting(perception, first); left != 0; left &= left - 1) {
      const Neighbour neighbour = perception.neighbours[first + lowestOf(left)];
      cutToGap(limitOf(perception, neighbour, sharing_), reach, moves, count);
    }
  }
  cutToWalls(perception, moves, count);
}

}  // namespace crowd
