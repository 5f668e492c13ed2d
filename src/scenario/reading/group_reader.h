#pragma once

#include "common/text/yaml_reader.h"
#include "scenario/group_share.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Reads `groups` of an entry of agents or of a source: a map with `share` and, optionally, `sizes`.
/// @throws InputError, as all functions of this file do
GroupShare readGroupShare(const YamlMap& map);

/// @brief Reads `leader` of an entry of agents: the number of an agent, or {robot: NAME}.
LeaderDescription readLeader(const YamlMap& map);

/// @brief Reads `groups` of a scenario: lists of the numbers of agents that walk together.
std::vector<GroupDescription> readGroups(const YamlMap& map);

/// @brief Checks groups and leaders, and finds the robots that lead.
void resolveGroups(Scenario& scenario, const YamlPlace& place);

}  // namespace crowd
