#include "navigation/congestion_map.h"

#include <algorithm>
#include <cmath>

namespace crowd {
namespace {

constexpr double LEAST_SHARE = 0.05;  // of the maximum speed: agents that stand count as this slow
constexpr double FREE_SHARE = 0.95;   // from which a flow is free
constexpr double PIECE = 0.5;         // of a way [m]

}  // namespace

void CongestionMap::update(const World& world, const AgentMap<RemainingPath>& paths) {
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    const RemainingPath& path = paths.nth(i);
    if (!agent.isWalking() || agent.at_goal || agent.isHeld() || path.empty()) continue;
    const Vector2 offset = path.front() - agent.pose.position;
    const double distance = offset.norm();
    if (distance == 0.0) continue;
    Flow& flow = flows_[keyOf(agent.pose.position, offset)];
    flow.sum += std::clamp(agent.velocity.dot(offset) / (distance * agent.max_speed), -1.0, 1.0);
    ++flow.agents;
  }
  for (auto place = flows_.begin(); place != flows_.end();) {
    Flow& flow = place->second;
    const bool is_empty = flow.agents == 0;
    const double share = is_empty ? 1.0 : flow.sum / flow.agents;
    flow.share += (share - flow.share) * std::min(1.0, world.tickDuration() / (is_empty ? FALL_TIME : RISE_TIME));
    flow.sum = 0.0;
    flow.agents = 0;
    place = is_empty && flow.share > FREE_SHARE ? flows_.erase(place) : std::next(place);
  }
}

double CongestionMap::shareAt(const Vector2& place, const Vector2& direction) const {
  const auto flow = flows_.find(keyOf(place, direction));
  return flow == flows_.end() ? 1.0 : flow->second.share;
}

CongestionMap::Delay CongestionMap::delayOn(const Vector2& from, Span<Vector2> corners, double speed) const {
  Delay delay;
  Vector2 start = from;
  for (const Vector2& corner : corners) {
    const Vector2 offset = corner - start;
    const double length = offset.norm();
    for (double walked = 0.0; walked < length; walked += PIECE) {
      const double piece = std::min(PIECE, length - walked);
      const Vector2 middle = start + (walked + 0.5 * piece) / length * offset;
      const double lost = piece / speed * (1.0 / std::max(LEAST_SHARE, shareAt(middle, offset)) - 1.0);
      delay.total += lost;
      if (lost < delay.worst) continue;
      delay.worst = lost;
      delay.place = middle;
    }
    start = corner;
  }
  return delay;
}

CongestionMap::Key CongestionMap::keyOf(const Vector2& place, const Vector2& direction) {
  const auto column = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(place.x() / CELL)));
  const auto row = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(place.y() / CELL)));
  const bool is_along_x = std::abs(direction.x()) > std::abs(direction.y());
  const Key side = is_along_x ? (direction.x() > 0.0 ? 0U : 1U) : (direction.y() > 0.0 ? 2U : 3U);
  return (Key{column} << 34U) ^ (Key{row} << 2U) ^ side;
}

}  // namespace crowd
