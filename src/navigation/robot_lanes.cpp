#include "navigation/robot_lanes.h"

#include <algorithm>
#include <optional>

namespace crowd {
namespace {

constexpr double STEP = 1.0;  // to the waypoint [m]; research/docs/robots.md, "Comfort"

bool opensLanes(const Robot& robot) {
  return robot.start.perceived && doesCrowdYield(robot.start.yields) && robot.start.comfort > 0.0 &&
         robot.waited >= RobotLanes::PATIENCE;
}

/// Where an agent steps aside: away from the robot and to its own side of the way; nothing if it may stay.
std::optional<Vector2> placeAside(const Agent& agent, const Robot& robot) {
  const Vector2 offset = agent.pose.position - robot.pose.position;
  const double distance = offset.norm();
  const double gap = distance - agent.radius - robot.perceived_radius;
  if (gap >= robot.start.comfort || distance <= 0.0) return std::nullopt;
  const Vector2 way = robot.wantedVelocity().normalized();
  const Vector2 away = offset / distance;
  const double side = cross(way, away) < 0.0 ? -1.0 : 1.0;
  const Vector2 aside = side * Vector2(-way.y(), way.x());
  return agent.pose.position + STEP * (away + aside).normalized();
}

}  // namespace

void RobotLanes::update(World& world, bool are_led) {
  const std::vector<AgentId> before = std::move(aside_);
  aside_.clear();
  for (const Robot& robot : world.robots()) {
    if (!opensLanes(robot)) continue;
    for (const Agent& agent : world.agents()) {
      if (!agent.isWalking() || agent.isHeld() || agent.at_goal) continue;
      const std::optional<Vector2> place = placeAside(agent, robot);
      if (!place) continue;
      Agent& walking = world.walkingAgent(agent.id);
      walking.yielding = false;
      walking.setWaypoint(*place);
      aside_.push_back(agent.id);
    }
  }
  std::sort(aside_.begin(), aside_.end());
  if (are_led) return;
  for (const AgentId agent : before) {
    const bool is_aside = std::binary_search(aside_.begin(), aside_.end(), agent);
    if (!is_aside && world.isActive(agent)) world.walkingAgent(agent).clearWaypoint();
  }
}

}  // namespace crowd
