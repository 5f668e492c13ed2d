#pragma once

#include <utility>
#include <vector>

#include "navigation/remaining_path.h"
#include "support/scenes.h"
#include "support/straight_walk.h"

/// Crowds that walk east and west along the x axis, without way-finding: for tests of rules at narrow places.
namespace crowd::two_ways {

constexpr double RADIUS = 0.2;  // [m]

/// An agent that walks east or west, to a goal on the other side of the y axis.
inline AgentStart walker(const Vector2& from, const Vector2& goal, double speed = 1.0) {
  return scenes::agent(from, goal, speed, RADIUS);
}

/// Ticks of 0.5 s, exact in binary.
inline World worldOf(std::vector<AgentStart> agents, std::vector<Segment> walls = {}) {
  return World(scenes::halfSeconds(scenes::scene(std::move(agents), {}, std::move(walls))));
}

inline bool walksEast(const Agent& agent) { return agent.goal().x() > 0.0; }

/// The paths of all agents: through the origin unless it is reached or passed (to 1 cm), then to the goal. They also
/// become the waypoints; what a rule set before is removed.
inline std::vector<RemainingPath> findPaths(World& world) {
  std::vector<RemainingPath> paths(world.agents().size());
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    world.walkingAgent(agent.id).yielding = false;
    world.walkingAgent(agent.id).clearWaypoint();
    const double passed = walksEast(agent) ? agent.pose.position.x() : -agent.pose.position.x();
    if (passed < -0.01) {
      paths[agent.id].push_back(Vector2::Zero());
      world.walkingAgent(agent.id).setWaypoint(Vector2::Zero());
    }
    paths[agent.id].push_back(agent.goal());
  }
  return paths;
}

/// Applies a rule to a world in which all agents have these paths.
template <typename Rule>
void apply(Rule& rule, World& world) {
  const std::vector<RemainingPath> paths = findPaths(world);
  rule.update(world, paths);
}

}  // namespace crowd::two_ways
