#pragma once

#include <vector>

#include "scenario/units.h"
#include "social_crowd/common/yaml_reader.h"
#include "social_crowd/scenario/population_spec.h"

namespace crowd {

/// @brief Reads `robots` of a document. @param goal_tolerance of the document [m] @param population its routes are
/// known by name @throws InputError
std::vector<RobotGroup> readRobots(const YamlMap& map, const Units& units, double goal_tolerance,
                                   const PopulationDescription& population);

}  // namespace crowd
