#pragma once

#include <string>

#include "scenario/scene.h"

namespace crowd {

/// @brief The entry `robots` of a document of a scenario file; empty without robots.
std::string robotsText(const Scene& scene);

}  // namespace crowd
