#include "ros/messages/agent_list.h"

#include <algorithm>

namespace crowd {

std::string agentList(const std::vector<AgentId>& agents, std::size_t most) {
  std::string text;
  const std::size_t count = std::min(most, agents.size());
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + std::to_string(agents[i]);
  return count < agents.size() ? text + " and " + std::to_string(agents.size() - count) + " more" : text;
}

std::string namedAgents(const std::vector<AgentId>& agents) {
  return (agents.size() == 1 ? "agent " : "agents ") + agentList(agents);
}

}  // namespace crowd
