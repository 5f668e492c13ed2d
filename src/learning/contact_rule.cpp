#include "social_crowd/learning/contact_rule.h"

#include <algorithm>

#include "social_crowd/common/errors.h"
#include "social_crowd/learning/time_to_contact.h"

namespace crowd {
namespace {

/// Left free of every gap, so that what two agents work out in their own frames never adds up to more than it [m].
constexpr double MARGIN = 1e-9;

/// By how much a mover is to be cleared [m], and how much earlier than need be [s].
constexpr double WAY_MARGIN = 0.02;
constexpr double WAY_SLACK = 0.3;

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

/// The room may be negative: something comes that leaves no place to stay.
Limit limitOfObstacle(const AgentPerception& self, const PerceivedBody& other, double tick_duration) {
  const Vector2 then = other.position + tick_duration * other.velocity;
  const double distance = then.norm();
  const double gap = distance - self.radius - other.radius;
  const bool at_rest = other.velocity == Vector2::Zero();
  Limit limit = limitOf(then, distance, gap);
  if (at_rest) limit.room = std::max(0.0, limit.room);
  return limit;
}

Limit limitOfWall(const AgentPerception& self, const Segment& wall) {
  const Vector2 nearest = nearestPoint(wall, Vector2::Zero());
  const double distance = nearest.norm();
  Limit limit = limitOf(nearest, distance, distance - self.radius);
  limit.room = std::max(0.0, limit.room);
  return limit;
}

/// The lane that a moving obstacle sweeps is a wall to those outside; who is in it may go on towards its limit only.
Limit limitOfLane(const AgentPerception& self, const PerceivedBody& other, double lane_time) {
  const Vector2 nearest = nearestPoint({other.position, other.position + lane_time * other.velocity}, Vector2::Zero());
  const double distance = nearest.norm();
  Limit limit = limitOf(nearest, distance, distance - self.radius - other.radius);
  limit.room = std::max(0.0, limit.room);
  return limit;
}

bool isMover(const PerceivedBody& body) { return body.kind == BodyKind::OBSTACLE && body.velocity != Vector2::Zero(); }

/// Who stands in the way of a mover, and has no time to lose any more, goes out of it: moves that would not clear it
/// become the straight way out.
void clearWay(const AgentPerception& self, const PerceivedBody& mover, CandidateMove* moves, std::size_t count) {
  const double reach = self.radius + mover.radius + WAY_MARGIN;
  const Vector2 ahead = mover.velocity.normalized();
  const double side = cross(ahead, -mover.position);
  const double way_out = (reach - std::abs(side)) / self.speed;  // [s]
  if (timeToContact(mover.position, -mover.velocity, reach) > way_out + WAY_SLACK) return;
  const Vector2 left(-ahead.y(), ahead.x());
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2 velocity = moves[i].share * self.speed * moves[i].direction;
    if (timeToContact(mover.position, velocity - mover.velocity, reach) >= NEVER) continue;
    moves[i] = {side < 0.0 ? Vector2(-left) : left, 1.0, 1.0};
  }
}

/// @param reach the longest displacement of a tick [m]
void apply(const Limit& limit, double reach, CandidateMove* moves, std::size_t count) {
  if (limit.room >= reach) return;
  for (std::size_t i = 0; i < count; ++i) {
    const double advance = reach * limit.normal.dot(moves[i].direction);
    const bool too_far = advance > 0.0 && moves[i].share * advance > limit.room;
    if (too_far) moves[i].share = std::max(0.0, limit.room / advance);
  }
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

void ContactRule::cut(const Perception& perception, CandidateMove* moves, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) moves[i].share = moves[i].wanted;
  if (sharing_ == GapSharing::NONE) return;
  const AgentPerception& self = perception.self;
  const double reach = self.speed * perception.tick_duration;
  for (const PerceivedBody& body : perception.bodies) {
    if (isMover(body)) clearWay(self, body, moves, count);
  }
  for (const PerceivedBody& body : perception.bodies) {
    const Limit limit = body.kind == BodyKind::AGENT ? limitOfAgent(self, body, perception.tick_duration, sharing_)
                                                     : limitOfObstacle(self, body, perception.tick_duration);
    apply(limit, reach, moves, count);
    if (isMover(body) && lane_time_ > 0.0) apply(limitOfLane(self, body, lane_time_), reach, moves, count);
  }
  for (const Segment& wall : perception.walls) apply(limitOfWall(self, wall), reach, moves, count);
}

}  // namespace crowd
