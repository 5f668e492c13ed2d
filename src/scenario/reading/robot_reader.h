#pragma once

#include <string>
#include <vector>

#include "common/text/yaml_reader.h"
#include "scenario/population_spec.h"
#include "scenario/reading/units.h"
#include "scenario/robot.h"

namespace crowd {

/// @brief Reads `robots` of a document. @param goal_tolerance of the document [m] @param population its routes are
/// known by name @throws InputError
std::vector<RobotGroup> readRobots(const YamlMap& map, const Units& units, double goal_tolerance,
                                   const PopulationDescription& population);

/// @brief Reads a name of letters, digits and _. @throws InputError
std::string readRobotName(const YamlMap& map, const std::string& key);

/// @brief Reads the keys `radius` or `footprint` of a map. @throws InputError unless it has one of them
void readFootprint(const YamlMap& map, Footprint& footprint);
/// @brief Reads one robot, whose places and heading are fixed. @param entry of `robots`, in YAML @param goal_tolerance
/// unless it has its own [m] @param is_only there is no other robot, so that it needs no namespace @param other_name if
/// it has none @throws InputError
RobotStart readRobotStart(const std::string& entry, double goal_tolerance, bool is_only,
                          const std::string& other_name = "");

}  // namespace crowd
