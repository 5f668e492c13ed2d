#pragma once

#include <string>
#include <vector>

#include "common/files/files.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Reads a scenario file: a stream of YAML documents, one scenario each (schema: docs/scenarios.md).
/// @throws FileError if it cannot be read; InputError with file, document, line and the expected value; Stopped if
/// `stop` is made
ScenarioList readScenarios(const std::string& file, const StopRequest& stop = {}, FileKinds kinds = FileKinds::REGULAR);

/// @brief Reads the scenarios of several files, in the order of the files. @throws as above.
ScenarioList readScenarios(const std::vector<std::string>& files, const StopRequest& stop = {});

/// @brief Reads scenarios from a text; `name` replaces the file name in messages. @throws InputError as above.
ScenarioList parseScenarios(const std::string& text, const std::string& name);

}  // namespace crowd
