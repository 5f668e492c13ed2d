#pragma once

#include <string>
#include <vector>

namespace crowd {

/// @brief Folder of the shipped scenarios: the installed one, or else the one in the source tree.
std::string shippedScenarios();

/// @brief Names of the scenarios in a folder and in the folders in it, in alphabetical order; none if it cannot be
/// read.
std::vector<std::string> scenarioNames(const std::string& folder = shippedScenarios());

/// @brief Resolves a scenario file or scenario name to a file.
///
/// An existing file takes precedence. Otherwise a bare name, with or without `.yaml`, is looked up in `folder`, then in
/// the folders in it. Command lines, training configurations, parameters and services all use this rule.
/// @param base folder of relative paths; empty: the working directory
/// @param folder of the named scenarios
/// @throws InputError with the searched locations and the available scenarios, most similar name first.
std::string findScenario(const std::string& name_or_file, const std::string& base = "",
                         const std::string& folder = shippedScenarios());

}  // namespace crowd
