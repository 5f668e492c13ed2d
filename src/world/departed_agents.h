#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>

#include "world/agent.h"

namespace crowd {

/// @brief What a world keeps of all agents together that have left it.
struct DepartedAgents {
  // Of those that arrived:
  std::uint32_t arrived = 0;
  std::uint32_t touched = 0;   ///< that were in contact
  std::uint32_t collided = 0;  ///< that were in collision
  // Of all of them:
  double largest_radius = 0.0;  ///< [m]
  Eigen::AlignedBox2d places;   ///< contains their last places and goals [m], `map`

  void add(const Agent& agent) {
    if (agent.hasArrived()) {
      ++arrived;
      touched += agent.touched ? 1 : 0;
      collided += agent.collided ? 1 : 0;
    }
    largest_radius = std::max(largest_radius, agent.radius);
    places.extend(agent.pose.position);
    for (const Vector2& goal : agent.goals) places.extend(goal);
  }
};

}  // namespace crowd
