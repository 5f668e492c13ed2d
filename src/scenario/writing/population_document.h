#pragma once

#include <string>
#include <vector>

#include "scenario/population_spec.h"

namespace crowd {

/// @brief "LOW" or "[LOW, HIGH]".
std::string rangeText(const Range& range);

/// @brief "[X, Y]" [m].
std::string pointText(const Vector2& point);

/// @brief "[[X, Y], ...]" [m].
std::string pointsText(const std::vector<Vector2>& points);

/// @brief A heading: in degrees if a reader gets the same number from these, or else "{radians: ANGLE}".
std::string headingText(double heading);

/// @brief A text as a single-quoted YAML scalar.
std::string quotedYaml(const std::string& text);

/// @brief The keys of a population in a scenario document.
std::string populationText(const PopulationDescription& population);

}  // namespace crowd
