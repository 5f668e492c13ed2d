#pragma once

#include <string>

#include "social_crowd/world/scene.h"

namespace crowd {

/// @brief A scene as a document of a scenario file (docs/scenarios.md) with fixed numbers for all drawn values, so that
/// the same scene can be plotted or replayed.
std::string toDocument(const Scene& scene);

}  // namespace crowd
