#pragma once

#include <utility>
#include <vector>

#include "support/scenes.h"

/// Builders of robots for tests.
namespace crowd::robots {

using scenes::scene;
using scenes::solid;
using scenes::wanderer;

/// A disc robot at a position that faces along x: 0.3 m, 1 m/s, without a goal, with high limits of acceleration.
inline RobotStart robot(const Vector2& position, double heading = 0.0) {
  RobotStart start;
  start.name = "robot";
  start.position = position;
  start.heading = heading;
  start.limits = {1.0, 1.0, 1e3, 1e3, 0.0};
  start.footprint.radius = 0.3;
  start.goal_tolerance = 0.1;
  return start;
}

/// The same robot on its way to a goal.
inline RobotStart robotTo(const Vector2& goal, const Vector2& position) {
  RobotStart start = robot(position, bearingOf(goal - position));
  start.goals = {goal};
  return start;
}

inline Scene with(std::vector<RobotStart> robots, Scene scene) {
  scene.robots = std::move(robots);
  return scene;
}

}  // namespace crowd::robots
