#pragma once

#include <string>

namespace crowd {

/// @brief The folder of the scenarios that come with the package, installed or in its source tree.
std::string shippedScenarios();

/// @brief The file that somebody means who names a scenario.
///
/// That is a file, if there is one of that path; else, of a bare name with or without `.yaml`, the scenario of that
/// name in a folder. So a file wins over a name, everywhere: command lines, training configurations, parameters and
/// services.
/// @param base relative paths of files begin there; empty: in the working directory
/// @param folder of the scenarios that have names
/// @throws InputError telling where it was looked for and, the nearest first, which scenarios are there.
std::string findScenario(const std::string& name_or_file, const std::string& base = "",
                         const std::string& folder = shippedScenarios());

}  // namespace crowd
