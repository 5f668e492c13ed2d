#pragma once

#include "common/text/yaml_reader.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Reads the key `map` of a scenario document, the path of a map file relative to it, if it has one. Sets the
/// scenario's map, its walls and, if a region is {map: free}, the free space for the largest agent. With or
/// without a map, it sets where agents can walk, if their places are drawn. Agents, obstacles, walls and `way_finding`
/// must have been read.
/// @param reach_points grid points of FloorReach that may still be made for all scenarios of a file, each some 8 bytes;
/// agents of a size for which they do not suffice are drawn without it
/// @throws InputError if {map: free} is used without a map or no agent fits; FileError and InputError as readMap();
/// Stopped if `stop` is made
void readScenarioMap(const YamlMap& map, Scenario& scenario, double& reach_points, const StopRequest& stop = {});

}  // namespace crowd
