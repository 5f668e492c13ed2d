#pragma once

#include "common/text/yaml_reader.h"
#include "scenario/population_spec.h"
#include "scenario/reading/units.h"

namespace crowd {

/// @brief Reads an entry under `agents`. @param population its routes and kinds are known by name
/// @throws InputError, as all functions of this file do
AgentGroup readAgents(const YAML::Node& node, const YamlPlace& place, const Units& units,
                      const PopulationDescription& population);

/// @brief Reads `goal`, `goals` or `route`, `kind`, `speed`, `hurry` and `radius` of a map, which must have declared
/// them.
void readWalk(const YamlMap& map, const Units& units, const PopulationDescription& population, AgentGroup& group);

}  // namespace crowd
