#pragma once

#include "maps/free_space.h"
#include "scenario/population_spec.h"

namespace crowd {

/// @brief Whether free space connects a place [m] with the places, queues and sinks of a route. Regions count by their
/// middle; those with the middle in a wall, and {map: free}, are taken as connected.
bool connectsRoute(const FreeSpace& free_space, const PopulationDescription& population, std::size_t route,
                   const Vector2& from);

}  // namespace crowd
