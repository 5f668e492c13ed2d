#pragma once

#include <string>

#include "social_crowd/world/scene.h"

namespace crowd {

/// @brief A scene as a document of a scenario file (docs/scenarios.md): what was drawn at random stands there in
/// numbers, so that one and the same scene can be drawn on paper, or walked again.
std::string toDocument(const Scene& scene);

}  // namespace crowd
