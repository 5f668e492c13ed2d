#pragma once

#include <string>

#include "scenario/scene.h"

namespace crowd {

/// @brief A scene as a document of a scenario file (docs/scenarios.md) with fixed numbers for all drawn values, so that
/// the same scene can be plotted or replayed. A reader gets the same numbers, bit for bit; what is drawn during the
/// episode is the same for the same seed of the run and number of the episode.
/// @param folder of the scenario file; the path of the map's file is relative to it
std::string toDocument(const Scene& scene, const std::string& folder);

}  // namespace crowd
