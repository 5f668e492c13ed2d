#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "scenario/reading/scenario_reader.h"
#include "simulation/episode.h"

/// Crowds whose agents walk straight to what they perceive as their goal, and stop there.
namespace crowd::straight_walk {

inline std::vector<AgentAction> actions(const World& world) {
  std::vector<AgentAction> all;
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    const Vector2 way = agent.perceivedGoal() - agent.pose.position;
    const double share = std::min(1.0, way.norm() / (agent.max_speed * world.tickDuration()));
    const double rotation = way.norm() > 0.0 ? wrapAngle(bearingOf(way) - agent.pose.heading) : 0.0;
    all.push_back({agent.id, {rotation, share}});
  }
  return all;
}

/// The scene of a scenario with these keys, besides name, ticks of 0.5 s, and a goal tolerance of 0.1 m.
inline Scene sceneOf(const std::string& keys, double duration = 1000.0, std::uint64_t seed = 1) {
  const std::string head = "name: n\ntick: 0.5\ngoal_tolerance: 0.1\nduration: " + std::to_string(duration) + "\n";
  return parseScenarios(head + keys, "s.yaml").scene(seed, 0);
}

inline Episode episodeOf(const std::string& keys, double duration = 1000.0, std::uint64_t seed = 1) {
  return {sceneOf(keys, duration, seed), 0, Vision()};
}

/// Walks for one tick.
inline void step(Episode& episode) { episode.step(actions(episode.world())); }

/// Walks until this time [s] or the end of the episode.
inline void walkUntil(double time, Episode& episode) {
  while (episode.world().time() < time && !episode.isOver()) step(episode);
}

}  // namespace crowd::straight_walk
