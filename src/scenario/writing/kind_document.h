#pragma once

#include <string>

#include "scenario/population_spec.h"
#include "scenario/scene.h"

namespace crowd {

/// @brief The key `kind` of an agent, with a comma before it; nothing without a kind.
std::string kindText(const AgentStart& agent, const Scene& scene);
/// @brief The same of an entry of agents.
std::string kindText(const AgentGroup& agents, const PopulationDescription& population);

/// @brief The key `reaction`, with a comma before it; nothing for people who react as usual.
std::string reactionText(const AgentStart& agent);
std::string reactionText(const AgentGroup& agents);

/// @brief The key `kinds`: those that agents and sources of the scene name.
std::string kindsText(const Scene& scene);

}  // namespace crowd
