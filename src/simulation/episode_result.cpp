#include "simulation/episode_result.h"

#include <algorithm>

namespace crowd {

std::string outOfReachText(std::size_t agents) {
  return agents == 1 ? "1 agent has a goal out of reach" : std::to_string(agents) + " agents have goals out of reach";
}

std::string outOfReachText(const std::vector<AgentId>& agents) {
  constexpr std::size_t MOST = 10;
  std::string numbers;
  for (std::size_t i = 0; i < std::min(MOST, agents.size()); ++i) {
    numbers += (i == 0 ? "" : ", ") + std::to_string(agents[i]);
  }
  return outOfReachText(agents.size()) + " (" + numbers + (agents.size() > MOST ? ", ...)" : ")");
}

EpisodeResult::Counts EpisodeResult::count() const {
  Counts counts;
  for (const AgentResult& agent : agents) {
    if (agent.removed) continue;
    ++counts.agents;
    counts.arrived += agent.arrived ? 1 : 0;
    counts.expected += !agent.endless || agent.arrived ? 1 : 0;
    counts.touched += agent.touched ? 1 : 0;
    counts.collided += agent.collided ? 1 : 0;
    counts.blocked_moves += agent.blocked_moves;
  }
  return counts;
}

std::vector<AgentId> EpisodeResult::outOfReach() const {
  std::vector<AgentId> found;
  AgentId id = 0;
  for (const AgentResult& agent : agents) {
    if (agent.out_of_reach && !agent.removed) found.push_back(id);
    ++id;
  }
  return found;
}

std::string EpisodeResult::wayWarning() const {
  if (!way_finding_problem.empty()) return "way-finding was left out: " + way_finding_problem;
  const std::vector<AgentId> found = outOfReach();
  return found.empty() ? "" : outOfReachText(found);
}

std::vector<double> EpisodeResult::headings() const {
  std::vector<double> headings;
  headings.reserve(agents.size());
  for (const AgentResult& agent : agents) headings.push_back(agent.heading);
  return headings;
}

}  // namespace crowd
