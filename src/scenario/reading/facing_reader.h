#pragma once

#include <optional>

#include "common/text/yaml_reader.h"
#include "scenario/population_spec.h"

namespace crowd {

/// @brief Reads `face` of a map, which must have declared it: degrees, [x, y], or {robot: NAME}; absent without the
/// key. checkPopulation() looks for the robot. @throws InputError
std::optional<FacingDescription> readFacing(const YamlMap& map);

}  // namespace crowd
