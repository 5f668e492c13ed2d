#pragma once

#include <string>
#include <vector>

#include "scenario/scenario.h"

namespace crowd {

/// @brief Warnings of speeds and radii that no person has, each "FILE: document D, line L: FIELD: ...": of entries of
/// agents, sources and kinds. @param scenario with its population
std::vector<std::string> findUnlikelyPeople(const Scenario& scenario);

}  // namespace crowd
