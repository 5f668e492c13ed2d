#pragma once

#include <vector>

#include "common/text/yaml_reader.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Reads the key `recorded` of a scenario document and the recordings that it names, whose paths are relative to
/// the document.
/// @param tick_duration [s] of the scenario: the time between two frames of a file without a frame rate
/// @throws InputError with the place in the document, also about what is wrong in a recording
std::vector<RecordedGroup> readRecorded(const YamlMap& map, double tick_duration);

}  // namespace crowd
