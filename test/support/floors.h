#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "common/random.h"
#include "maps/floor_plan.h"
#include "meshes/navigation_mesh.h"

/// Floors for tests of way-finding, and distances on them.
namespace crowd::floors {

/// The walls of a rectangle.
inline FloorPlan room(const Vector2& low, const Vector2& high) {
  FloorPlan floor;
  const Vector2 right(high.x(), low.y());
  const Vector2 left(low.x(), high.y());
  floor.walls = {{low, right}, {right, high}, {high, left}, {left, low}};
  return floor;
}

/// A room from (-5, -4) to (5, 4) with a wall along the y axis; this wall has a door of a given width around a point.
inline FloorPlan roomWithDoor(double width, double door_y = 0.0) {
  FloorPlan floor = room({-5.0, -4.0}, {5.0, 4.0});
  floor.walls.push_back({{0.0, -4.0}, {0.0, door_y - 0.5 * width}});
  floor.walls.push_back({{0.0, door_y + 0.5 * width}, {0.0, 4.0}});
  return floor;
}

/// Distance from a point to the nearest wall or rim of an obstacle [m].
inline double clearanceAt(const FloorPlan& floor, const Vector2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Segment& wall : floor.walls) nearest = std::min(nearest, distanceTo(wall, point));
  for (const FloorPlan::Disc& disc : floor.obstacles) {
    nearest = std::min(nearest, (disc.centre - point).norm() - disc.radius);
  }
  return nearest;
}

/// Distance from a straight line to the nearest wall or rim, at points that are at most 5 mm apart [m].
inline double clearanceAlong(const FloorPlan& floor, const Vector2& from, const Vector2& to) {
  const double pieces = std::ceil((to - from).norm() / 0.005) + 1.0;
  double nearest = std::numeric_limits<double>::infinity();
  for (double i = 0.0; i <= pieces; ++i) {
    nearest = std::min(nearest, clearanceAt(floor, from + i / pieces * (to - from)));
  }
  return nearest;
}

/// The same of a whole path.
inline double clearanceOf(const FloorPlan& floor, const Vector2& start, const Path& path) {
  double nearest = std::numeric_limits<double>::infinity();
  Vector2 from = start;
  for (const Vector2& corner : path.corners) {
    nearest = std::min(nearest, clearanceAlong(floor, from, corner));
    from = corner;
  }
  return nearest;
}

/// Sum of the lengths of the straight parts of a path [m].
inline double lengthOf(const Vector2& start, const Path& path) {
  double length = 0.0;
  Vector2 from = start;
  for (const Vector2& corner : path.corners) {
    length += (corner - from).norm();
    from = corner;
  }
  return length;
}

/// A room of 6 m by 5 m with walls and round obstacles at random.
inline FloorPlan random(KeyedRandom& random) {
  FloorPlan floor = room({0.0, 0.0}, {6.0, 5.0});
  const auto point = [&] {
    const double x = random.uniform(0.0, 6.0);
    return Vector2(x, random.uniform(0.0, 5.0));
  };
  for (std::uint32_t left = 1 + random.below(6); left > 0; --left) {
    const Vector2 from = point();
    const bool upright = random.below(2) == 0;
    const double length = random.uniform(0.5, 4.0);
    const double angle = random.below(2) == 0 ? random.uniform(-PI, PI) : (upright ? 0.5 * PI : 0.0);
    floor.walls.push_back({from, from + length * unitVector(angle)});
  }
  for (std::uint32_t left = random.below(6); left > 0; --left) {
    const Vector2 centre = point();
    floor.obstacles.push_back({centre, random.uniform(0.05, 0.6)});
  }
  return floor;
}

}  // namespace crowd::floors
