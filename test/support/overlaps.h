#pragma once

#include "geometry/impact.h"
#include "scenario/scene.h"

namespace crowd::scenes {

/// @brief Whether an agent overlaps an earlier agent, an obstacle or a wall at the start by more than TOUCH_TOLERANCE.
/// Obstacles and walls may overlap each other.
inline bool hasOverlap(const Scene& scene) {
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    const AgentStart& agent = scene.agents[i];
    const auto overlaps = [&](const Vector2& centre, double radius) {
      return agent.radius + radius - (agent.position - centre).norm() > TOUCH_TOLERANCE;
    };
    for (std::size_t k = 0; k < i; ++k) {
      if (overlaps(scene.agents[k].position, scene.agents[k].radius)) return true;
    }
    for (const Obstacle& obstacle : scene.obstacles) {
      if (overlaps(obstacle.path.position(0.0), obstacle.radius)) return true;
    }
    for (const Segment& wall : scene.walls) {
      if (overlaps(nearestPoint(wall, agent.position), 0.0)) return true;
    }
  }
  return false;
}

}  // namespace crowd::scenes
