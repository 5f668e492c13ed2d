#pragma once

#include <string>

#include "social_crowd/world/population.h"

namespace crowd {

/// @brief "[X, Y]" [m].
std::string pointText(const Vector2& point);

/// @brief A text as a single-quoted YAML scalar.
std::string quoted(const std::string& text);

/// @brief The keys of a population in a scenario document.
std::string populationText(const PopulationDescription& population);

}  // namespace crowd
