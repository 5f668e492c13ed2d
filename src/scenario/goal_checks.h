#pragma once

#include "scenario/placed_bodies.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Whether a disc can come within a tolerance of a goal, as far as walls and obstacles near the goal say [m].
bool comesNear(const Vector2& goal, double radius, double tolerance, const Scenario& scenario,
               const PlacedBodies& placed);

/// @brief Checks the fixed goals of agents in a scenario with way-finding, as services do for theirs (WayLengths).
/// Goals that are drawn avoid walls and obstacles.
/// @param placed walls and the fixed obstacles of the scenario
/// @throws InputError with file, document and line for a goal in a wall, in a cell of the map that is not free, or in
/// an obstacle at rest, that is, farther from where its agent can stand than the goal tolerance
void requireFreeGoals(const Scenario& scenario, const PlacedBodies& placed);

}  // namespace crowd
