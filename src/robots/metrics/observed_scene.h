#pragma once

#include <optional>
#include <vector>

#include "geometry/wall_index.h"
#include "maps/floor_plan.h"
#include "world/world.h"

namespace crowd {

/// @brief A person near whom a robot is measured.
struct ObservedPerson {
  AgentId id = 0;
  Vector2 position = Vector2::Zero();  ///< [m], `map`
  double heading = 0.0;                ///< [rad], `map`
  Vector2 velocity = Vector2::Zero();  ///< in the last tick [m/s], `map`
  double radius = 0.0;                 ///< [m]
  GroupId group = NO_GROUP;
};

/// @brief An obstacle, where it is now.
struct ObservedObstacle {
  Vector2 position = Vector2::Zero();  ///< [m], `map`
  double radius = 0.0;                 ///< [m]
  bool moves = false;
};

/// @brief A robot, and what is not known of its state.
struct ObservedRobot {
  const Robot* robot = nullptr;
  const std::vector<RobotContact>* contacts = nullptr;  ///< with people, in the last tick
  /// Whether its velocity was changed by an impact, or a jump, in the last tick; absent: Robot knows.
  std::optional<bool> impact = std::nullopt;
  /// [m/s], `map`; NaN: it is not known; absent: Robot knows.
  std::optional<Vector2> velocity = std::nullopt;
};

/// @brief Everything that RobotMonitor measures, at the end of a tick: that of a World, or of a log of poses.
struct ObservedScene {
  double tick_duration = 0.0;  ///< [s]
  std::vector<ObservedRobot> robots;
  std::vector<ObservedPerson> people;  ///< those who are there, recorded ones at last
  std::vector<ObservedObstacle> obstacles;
  const WallIndex* walls = nullptr;  ///< of all walls, those of closed gates included

  /// @brief Takes over the present state of a world, to which the scene points until the world changes.
  void observe(const World& world);
};

/// @brief Walls and obstacles at rest, with all gates open. @param gates walls of the gates, whether they are closed or
/// not
FloorPlan floorOf(const ObservedScene& scene, const std::vector<Segment>& gates);

}  // namespace crowd
