#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "world/relative_action.h"

namespace crowd {

/// @brief Returns the numbers of agents as text, such as "1, 2, 5"; of more than `most` the first ones and the number
/// of the others.
std::string agentList(const std::vector<AgentId>& agents, std::size_t most = 20);

/// @brief Returns agentList() with the noun: "agent 1" or "agents 1, 2, 5".
std::string namedAgents(const std::vector<AgentId>& agents);

}  // namespace crowd
