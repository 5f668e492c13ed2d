#pragma once

#include "scenario/placed_bodies.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Reports a problem of a body. @throws InputError, with file, document and line
[[noreturn]] void refuse(const Scenario& scenario, const Label& label, const std::string& problem);

/// @brief Whether free space connects two places [m].
bool areConnected(const FreeSpace& free_space, const Vector2& from, const Vector2& to);

/// @brief Checks the distance between fixed starts and fixed goals: an agent that has arrived before it walks counts as
/// a success. What is drawn is drawn so that this does not happen. @throws InputError
void requireWay(const Scenario& scenario, const AgentGroup& group, const Label& label);

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
