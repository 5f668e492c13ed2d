#pragma once

#include <string>
#include <vector>

#include "social_crowd/world/scenario.h"

namespace crowd {

/// @brief Reads a scenario file: a stream of YAML documents, each a scenario (docs/scenarios.md has the
/// schema).
/// @throws FileError if it cannot be read; InputError with file, document, line and what was expected.
ScenarioList readScenarios(const std::string& file);

/// @brief The scenarios of several files, one after the other. @throws as above.
ScenarioList readScenarios(const std::vector<std::string>& files);

/// @brief The same from a text; `name` stands for the file in messages.
ScenarioList parseScenarios(const std::string& text, const std::string& name);

}  // namespace crowd
