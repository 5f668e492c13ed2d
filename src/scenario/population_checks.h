#pragma once

#include "scenario/scenario.h"

namespace crowd {

/// @brief Checks that agents fit where they are to be: somewhere in the area of each source, sink and place of a route,
/// and at the head of each queue. Walls and the map are considered, gates are not.
/// @param scenario completely read, with a population
/// @throws InputError with file, document, line and field
void checkPopulation(const Scenario& scenario);

}  // namespace crowd
