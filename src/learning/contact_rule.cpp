#include "social_crowd/learning/contact_rule.h"

#include <algorithm>
#include <array>
#include <optional>

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

/// Whether an agent is so far away that its limit lies beyond the longest displacement of a tick: half of the gap does,
/// less what the plane between both may go towards this one.
bool isFar(const AgentPerception& self, const PerceivedBody& other, double reach, double tick_duration) {
  const Vector2 sum = self.velocity + other.velocity;
  const double drift = tick_duration * (std::abs(sum.x()) + std::abs(sum.y()));
  const double near = self.radius + other.radius + 2.0 * (reach + MARGIN) + drift + ROUNDING;
  return other.position.squaredNorm() > near * near;
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

/// Moves side by side; the last one again in the lanes that are left.
struct MoveLanes {
  static constexpr std::size_t SIZE = 24;
  using Lanes = std::array<double, SIZE>;

  alignas(64) Lanes x;  // direction
  alignas(64) Lanes y;
  alignas(64) Lanes share;

  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): written below, and zeroing first takes time
  MoveLanes(const CandidateMove* moves, std::size_t count) {
    for (std::size_t i = 0; i < SIZE; ++i) {
      const CandidateMove& move = moves[std::min(i, count - 1)];
      x[i] = move.direction.x();
      y[i] = move.direction.y();
      share[i] = move.wanted;
    }
  }
};

/// @param reach the longest displacement of a tick [m]
CROWD_VECTORISED void apply(const Limit& limit, double reach, MoveLanes& moves) {
  const double nx = limit.normal.x();
  const double ny = limit.normal.y();
  for (std::size_t i = 0; i < MoveLanes::SIZE; ++i) {
    const double advance = reach * (nx * moves.x[i] + ny * moves.y[i]);
    const bool too_far = (advance > 0.0) & (moves.share[i] * advance > limit.room);
    const double left = limit.room / advance;
    moves.share[i] = too_far ? left : moves.share[i];
  }
}

/// Cuts moves to the gaps, MoveLanes::SIZE at most.
void cutSome(const Perception& perception, GapSharing sharing, CandidateMove* moves, std::size_t count) {
  std::optional<MoveLanes> lanes;  // where nothing is near they are not needed
  const AgentPerception& self = perception.self;
  const double reach = self.speed * perception.tick_duration;
  const auto keep = [&](const Limit& limit) {
    if (limit.room >= reach) return;
    if (!lanes) lanes.emplace(moves, count);
    apply(limit, reach, *lanes);
  };
  for (const PerceivedBody& body : perception.bodies) {
    if (isMover(body)) continue;
    if (body.kind == BodyKind::OBSTACLE) {
      keep(limitOfObstacle(self, body));
    } else if (!isFar(self, body, reach, perception.tick_duration)) {
      keep(limitOfAgent(self, body, perception.tick_duration, sharing));
    }
  }
  for (const Segment& wall : perception.walls) keep(limitOfWall(self, wall));
  for (std::size_t i = 0; i < count; ++i) moves[i].share = lanes ? lanes->share[i] : moves[i].wanted;
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
  cutToGaps(perception, moves, count);
  const bool has_movers = std::any_of(perception.bodies.begin(), perception.bodies.end(), isMover);
  if (!has_movers || sharing_ == GapSharing::NONE || lookout_ <= 0.0) return;
  WayOut way_out(perception, lookout_);
  if (!way_out.isNeeded()) return;
  cutToGaps(perception, way_out.plainMoves(), way_out.plainMoveCount());
  way_out.replaceUnsafe(moves, count);
}

void ContactRule::cutToGaps(const Perception& perception, CandidateMove* moves, std::size_t count) const {
  if (sharing_ == GapSharing::NONE) {
    for (std::size_t i = 0; i < count; ++i) moves[i].share = moves[i].wanted;
    return;
  }
  for (std::size_t first = 0; first < count; first += MoveLanes::SIZE) {
    cutSome(perception, sharing_, moves + first, std::min<std::size_t>(count - first, MoveLanes::SIZE));
  }
}

}  // namespace crowd
