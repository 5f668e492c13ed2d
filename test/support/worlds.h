#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "world/perceiver.h"

/// Helpers for tests of the world.
namespace crowd {

/// Vision without limits.
constexpr Vision FAR_SIGHT{1e6, 0};

inline void expectVector(const Vector2& v, double x, double y) {
  EXPECT_NEAR(v.x(), x, 1e-12);
  EXPECT_NEAR(v.y(), y, 1e-12);
}

/// All values that a step changes, for comparing worlds bit for bit.
inline std::vector<double> stateOf(const World& world) {
  std::vector<double> state = {static_cast<double>(world.tick()), static_cast<double>(world.activeCount())};
  for (const Agent& agent : world.agents()) {
    state.insert(state.end(), {agent.pose.position.x(), agent.pose.position.y(), agent.pose.heading, agent.velocity.x(),
                               agent.velocity.y(), static_cast<double>(agent.next_goal),
                               static_cast<double>(agent.status), static_cast<double>(agent.arrival_tick)});
    state.insert(state.end(), {agent.acted ? 1.0 : 0.0, agent.in_contact ? 1.0 : 0.0, agent.touched ? 1.0 : 0.0,
                               agent.goal().x(), agent.goal().y()});
  }
  for (const Obstacle& obstacle : world.obstacles()) {
    state.push_back(obstacle.path.position(world.time()).x());
    state.push_back(obstacle.radius);
  }
  return state;
}

/// Writes the perceptions of all agents.
inline void perceive(const World& world, const Vision& vision, Perceptions& perceptions) {
  Viewers viewers;
  Perceiver().perceive(world, vision, viewers.all(world), perceptions);
}

/// The perceptions of all agents.
inline Perceptions perceive(const World& world, const Vision& vision = Vision()) {
  Perceptions perceptions;
  perceive(world, vision, perceptions);
  return perceptions;
}

/// The perceptions of all agents at the start of a scene.
inline Perceptions perceive(const Scene& scene, const Vision& vision = Vision()) {
  World world(scene);
  return perceive(world, vision);
}

/// The perceptions of all agents with unlimited vision.
inline Perceptions lookAround(const World& world) { return perceive(world, FAR_SIGHT); }

/// Straight ahead at full speed.
inline AgentAction ahead(AgentId id) { return {id, {0.0, 1.0}}; }

}  // namespace crowd
