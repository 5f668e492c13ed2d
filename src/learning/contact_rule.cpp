#include "social_crowd/learning/contact_rule.h"

#include <algorithm>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/fixed_list.h"
#include "social_crowd/learning/near_agents.h"
#include "social_crowd/learning/way_out.h"

namespace crowd {
namespace {

/// No displacement may reach further than `room` along `normal`.
struct Limit {
  Vector2 normal = Vector2::Zero();
  double room = 0.0;  // [m]
};

inline Limit limitOf(const Vector2& towards, double distance, double room) {
  // Bodies on one and the same point: no direction is better than another, and each is as far in the other as can be.
  if (distance <= 0.0) return {Vector2::Zero(), 0.0};
  return {towards / distance, room - GAP_MARGIN};
}

inline Limit limitOfAgent(const AgentPerception& self, const PerceivedBody& other, double tick_duration,
                          GapSharing sharing) {
  const double distance = other.position.norm();
  const double gap = std::max(0.0, distance - self.radius - other.radius);
  Limit limit = limitOf(other.position, distance, 0.5 * gap);
  if (sharing == GapSharing::MOVING) {
    // The plane between both goes along with the mean of their last velocities, but not out of the gap.
    const double shift = 0.5 * tick_duration * limit.normal.dot(self.velocity + other.velocity);
    limit.room += std::clamp(shift, -0.5 * gap, 0.5 * gap);
  }
  limit.room = std::max(0.0, limit.room);
  return limit;
}

Limit limitOfObstacle(const AgentPerception& self, const PerceivedBody& other) {
  const double distance = other.position.norm();
  Limit limit = limitOf(other.position, distance, distance - self.radius - other.radius);
  limit.room = std::max(0.0, limit.room);
  return limit;
}

Limit limitOfWall(const AgentPerception& self, const Segment& wall) {
  const Vector2 nearest = nearestPoint(wall, Vector2::Zero());
  const double distance = nearest.norm();
  Limit limit = limitOf(nearest, distance, distance - self.radius);
  limit.room = std::max(0.0, limit.room);
  return limit;
}

/// All that is wanted is admissible as long as nothing is in the way. By whole registers: a copy in smaller pieces
/// could not be read by such before it is in the cache.
void admitAll(MoveBlock* moves, std::size_t count) {
  for (std::size_t block = 0; block < blocksOf(count); ++block) {
    for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) moves[block].share[i] = moves[block].wanted[i];
  }
}

/// @param reach the longest displacement of a tick [m]
void apply(const Limit& limit, double reach, MoveBlock& moves) {
  const double nx = limit.normal.x();
  const double ny = limit.normal.y();
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) {
    const double advance = reach * (nx * moves.x[i] + ny * moves.y[i]);
    const bool too_far = (advance > 0.0) & (moves.share[i] * advance > limit.room);
    const double left = limit.room / advance;
    moves.share[i] = too_far ? left : moves.share[i];
  }
}

void cutToGap(const Limit& limit, double reach, MoveBlock* moves, std::size_t count) {
  if (limit.room >= reach) return;
  for (std::size_t block = 0; block < blocksOf(count); ++block) apply(limit, reach, moves[block]);
}

/// A limit that some of an agent's moves may have to be cut to.
struct Cut {
  Limit limit;
  double reach = 0.0;  // the longest displacement of a tick [m]
  MoveBlock* moves = nullptr;
};

/// Those among LOOKED_AT bodies that may limit a move: agents that are near, and obstacles that do not move.
BodySet findLimiting(const Perception& seen, std::size_t first) {
  BodySet limiting = findNear(seen, first);
  if (!seen.bodies.hasObstacles()) return limiting;
  const std::size_t count = std::min(LOOKED_AT, seen.bodies.size() - first);
  for (std::size_t i = 0; i < count; ++i) {
    const PerceivedBody body = seen.bodies[first + i];
    if (body.kind == BodyKind::AGENT) continue;
    limiting = isMover(body) ? limiting & ~(BodySet{1} << i) : limiting | BodySet{1} << i;
  }
  return limiting;
}

}  // namespace

GapSharing parseGapSharing(const std::string& text) {
  if (text == "none") return GapSharing::NONE;
  if (text == "half") return GapSharing::HALF;
  if (text == "moving") return GapSharing::MOVING;
  throw InputError("gap_sharing: expected none, half or moving, got '" + text + "'");
}

std::string toText(GapSharing sharing) {
  if (sharing == GapSharing::NONE) return "none";
  return sharing == GapSharing::HALF ? "half" : "moving";
}

void ContactRule::cut(const Choosers& choosers, std::size_t count) const {
  for (const Chooser& chooser : choosers) {
    if (NearAgents::isFor(chooser.seen)) {
      admitAll(chooser.moves, count);
    } else {
      cut(chooser.seen, chooser.moves, count);
    }
  }
  if (sharing_ != GapSharing::NONE) cutAmongAgents(choosers, count);
}

/// All limits of all agents as one list, first those that may be limits, then those that are: how many an agent has,
/// nobody can guess.
void ContactRule::cutAmongAgents(const Choosers& choosers, std::size_t count) const {
  FixedList<Cut, NearAgents::MOST> cuts;
  for (const NearAgent near : NearAgents(choosers)) {
    const Chooser& chooser = choosers[near.chooser()];
    const AgentPerception& self = chooser.seen.self;
    const double tick_duration = chooser.seen.tick_duration;
    const double reach = self.speed * tick_duration;
    const Limit limit = limitOfAgent(self, chooser.seen.bodies[near.body()], tick_duration, sharing_);
    cuts.add(limit, reach, chooser.moves);
    cuts.keepLastIf(limit.room < reach);
  }
  for (const Cut& each : cuts) cutToGap(each.limit, each.reach, each.moves, count);
}

void ContactRule::cut(const Perception& perception, MoveBlock* moves, std::size_t count) const {
  cutToGaps(perception, moves, count);
  if (!perception.bodies.hasObstacles() || sharing_ == GapSharing::NONE || lookout_ <= 0.0) return;
  WayOut way_out(perception, lookout_);
  if (!way_out.isNeeded()) return;
  cutToGaps(perception, way_out.plainMoves(), way_out.plainMoveCount());
  way_out.replaceUnsafe(moves, count);
}

void ContactRule::cutToGaps(const Perception& perception, MoveBlock* moves, std::size_t count) const {
  admitAll(moves, count);
  if (sharing_ == GapSharing::NONE) return;
  const AgentPerception& self = perception.self;
  const double reach = self.speed * perception.tick_duration;
  for (std::size_t first = 0; first < perception.bodies.size(); first += LOOKED_AT) {
    for (BodySet left = findLimiting(perception, first); left != 0; left &= left - 1) {
      const PerceivedBody body = perception.bodies[first + static_cast<std::size_t>(__builtin_ctz(left))];
      const bool agent = body.kind == BodyKind::AGENT;
      cutToGap(agent ? limitOfAgent(self, body, perception.tick_duration, sharing_) : limitOfObstacle(self, body),
               reach, moves, count);
    }
  }
  for (const Segment& wall : perception.walls) cutToGap(limitOfWall(self, wall), reach, moves, count);
}

}  // namespace crowd
