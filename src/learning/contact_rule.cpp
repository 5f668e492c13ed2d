#include "social_crowd/learning/contact_rule.h"

#include <algorithm>
#include <array>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/vectorised.h"
#include "social_crowd/learning/way_out.h"

namespace crowd {
namespace {

/// Left free of every gap, so that what two agents work out in their own frames never adds up to more than it [m].
constexpr double MARGIN = 1e-9;

/// More than the rounding of a distance [m].
constexpr double ROUNDING = 1e-6;

/// No displacement may reach further than `room` along `normal`.
struct Limit {
  Vector2 normal = Vector2::Zero();
  double room = 0.0;  // [m]
};

Limit limitOf(const Vector2& towards, double distance, double room) {
  // Bodies on one and the same point: no direction is better than another, and each is as far in the other as can be.
  if (distance <= 0.0) return {Vector2::Zero(), 0.0};
  return {towards / distance, room - MARGIN};
}

Limit limitOfAgent(const AgentPerception& self, const PerceivedBody& other, double tick_duration, GapSharing sharing) {
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
CROWD_VECTORISED void admitAll(MoveBlock& moves) {
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) moves.share[i] = moves.wanted[i];
}

/// @param reach the longest displacement of a tick [m]
CROWD_VECTORISED void apply(const Limit& limit, double reach, MoveBlock& moves) {
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

/// Bodies are looked at so many at a time; bit i of a set of them stands for body first + i.
constexpr std::size_t LOOKED_AT = PerceivedBodies::MARGIN;
using BodySet = std::uint64_t;

std::size_t firstOf(BodySet set) { return static_cast<std::size_t>(__builtin_ctzll(set)); }

/// The sets of one body each, to be read side by side.
constexpr std::array<BodySet, LOOKED_AT> setsOfOne() {
  std::array<BodySet, LOOKED_AT> sets{};
  for (std::size_t i = 0; i < LOOKED_AT; ++i) sets[i] = BodySet{1} << i;
  return sets;
}
constexpr std::array<BodySet, LOOKED_AT> ALONE = setsOfOne();

/// Those of LOOKED_AT bodies which, as agents, are not so far away that their limit lies beyond the longest
/// displacement of a tick: it does if half of the gap does, less what the plane between both may come towards this one.
/// All is multiplied by the distance, so that no root is taken.
CROWD_VECTORISED BodySet findNear(const PerceivedBodiesView& bodies, std::size_t first, const AgentPerception& self,
                                  double reach, double tick_duration) {
  const double* xs = bodies.xs() + first;
  const double* ys = bodies.ys() + first;
  const double* vxs = bodies.vxs() + first;
  const double* vys = bodies.vys() + first;
  const double* radii = bodies.radii() + first;
  const double vx = self.velocity.x();
  const double vy = self.velocity.y();
  const double room = 2.0 * (reach + MARGIN);
  BodySet near = 0;
  for (std::size_t i = 0; i < LOOKED_AT; ++i) {
    const double receding = xs[i] * (vx + vxs[i]) + ys[i] * (vy + vys[i]);
    const double square = xs[i] * xs[i] + ys[i] * ys[i];
    const double rest = square + tick_duration * std::min(0.0, receding);
    const double apart = self.radius + radii[i] + room + ROUNDING;
    const bool far = (rest > 0.0) & (rest * rest > apart * apart * square);
    near |= far ? BodySet{0} : ALONE[i];
  }
  return near;
}

/// Those among the bodies that may limit a move: agents that are near, and obstacles that do not move.
BodySet findLimiting(const Perception& perception, std::size_t first, double reach) {
  const PerceivedBodiesView& bodies = perception.bodies;
  const std::size_t count = std::min(LOOKED_AT, bodies.size() - first);
  BodySet limiting =
      findNear(bodies, first, perception.self, reach, perception.tick_duration) & ((BodySet{1} << count) - 1);
  if (!bodies.hasObstacles()) return limiting;
  for (std::size_t i = 0; i < count; ++i) {
    const PerceivedBody body = bodies[first + i];
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

void ContactRule::cut(const Perception& perception, MoveBlock* moves, std::size_t count) const {
  cutToGaps(perception, moves, count);
  if (!perception.bodies.hasObstacles() || sharing_ == GapSharing::NONE || lookout_ <= 0.0) return;
  WayOut way_out(perception, lookout_);
  if (!way_out.isNeeded()) return;
  cutToGaps(perception, way_out.plainMoves(), way_out.plainMoveCount());
  way_out.replaceUnsafe(moves, count);
}

void ContactRule::cutToGaps(const Perception& perception, MoveBlock* moves, std::size_t count) const {
  for (std::size_t block = 0; block < blocksOf(count); ++block) admitAll(moves[block]);
  if (sharing_ == GapSharing::NONE) return;
  const AgentPerception& self = perception.self;
  const double reach = self.speed * perception.tick_duration;
  for (std::size_t first = 0; first < perception.bodies.size(); first += LOOKED_AT) {
    for (BodySet left = findLimiting(perception, first, reach); left != 0; left &= left - 1) {
      const PerceivedBody body = perception.bodies[first + firstOf(left)];
      const bool agent = body.kind == BodyKind::AGENT;
      cutToGap(agent ? limitOfAgent(self, body, perception.tick_duration, sharing_) : limitOfObstacle(self, body),
               reach, moves, count);
    }
  }
  for (const Segment& wall : perception.walls) cutToGap(limitOfWall(self, wall), reach, moves, count);
}

}  // namespace crowd
