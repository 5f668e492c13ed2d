#pragma once

#include <vector>

#include "maps/floor_plan.h"
#include "scenario/scene.h"
#include "world/world_editor.h"

namespace crowd {

/// @brief The radius of the largest agent so far [m]; 0 without agents.
/// @param change the answer is that after it
double largestRadius(const World& world, const WorldChange& change = {});

/// @brief The radius of the largest agent that the sources of a scene may create [m]; 0 without sources.
double largestSourceRadius(const Scene& scene);

/// @brief The floor that ways are found on: walls, obstacles at rest, and bounds around them, all agents so far and
/// their goals. Small obstacles that stand alone are left to the learners, which walk round them with shorter paths.
/// @param radius of the agents [m] @param change the floor is that after it
/// @throws Stopped if the world's stop request is made
FloorPlan walkingFloor(const World& world, double radius, const WorldChange& change = {});

/// @brief Whether there is anything to walk round.
inline bool hasBarriers(const FloorPlan& floor) { return !floor.walls.empty() || !floor.obstacles.empty(); }

/// @brief Grows the bounds of a floor, so that they contain a point [m] and some space around it.
void includePoint(const Vector2& point, FloorPlan::Bounds& bounds);

/// @brief Whether bounds contain a point [m].
bool contains(const FloorPlan::Bounds& bounds, const Vector2& point);

/// @brief The walls of all gates of a scene, whether they are closed or not.
std::vector<Segment> gateWalls(const Scene& scene);

/// @brief Removes the walls of closed gates. @return whether there were any
bool openGates(const std::vector<Segment>& gates, FloorPlan& floor);

}  // namespace crowd
