#pragma once

#include <vector>

#include "world/world.h"

namespace crowd {

/// @brief Lets people step aside from robots that wait on their way to a goal, so that a lane opens: those within the
/// comfort of a robot (RobotStart::comfort) walk away from it and out of its way, until it drives on, or they have
/// room. They perceive a waypoint in place of their goal (World::setWaypoint). Deterministic.
///
/// Call contract: update() once per tick, after waypoints were set.
class RobotLanes {
 public:
  static constexpr double PATIENCE = 1.0;  ///< a robot has waited for this time [s]

  /// @brief Sets waypoints, and clears those that it has set before where nobody else sets them.
  /// @param are_led waypoints are set anew in each tick
  void update(World& world, bool are_led);

 private:
  std::vector<AgentId> aside_;  // agents that stepped aside in the last tick, by ascending id
};

}  // namespace crowd
