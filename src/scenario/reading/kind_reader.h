#pragma once

#include <vector>

#include "common/text/yaml_reader.h"
#include "scenario/person_kind.h"
#include "scenario/population_spec.h"
#include "scenario/reading/units.h"

namespace crowd {

/// @brief The kinds of people that the entries of a scenario document may name: those under `kinds`, a map or the name
/// of a file with one, and those of the package that have other names. Empty if no entry has a `kind`.
/// @throws InputError, FileError
std::vector<PersonKind> readKinds(const YamlMap& map, const Units& units);

/// @brief Reads `kind` of an entry of agents: a name, or a map of names and their shares. Without the key the entry has
/// no kinds. Sets the ranges of speed and radius to those of all its kinds together. @throws InputError
void readKindsOf(const YamlMap& map, const std::vector<PersonKind>& kinds, AgentGroup& group);

/// @brief Reads `reaction` of an entry of agents in the same way. @throws InputError
void readReactions(const YamlMap& map, AgentGroup& group);

/// @brief Removes the kinds that no entry names.
void keepUsedKinds(std::vector<AgentGroup>& agents, PopulationDescription& population);

/// @brief File with the kinds of the package.
std::string shippedKindsFile();

}  // namespace crowd
