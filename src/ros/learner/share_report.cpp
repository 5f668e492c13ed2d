#include "ros/learner/share_report.h"

#include <algorithm>

#include "ros/messages/agent_list.h"

namespace crowd {

void TakeReport::note(AgentId agent, const AgentTables::Taken& taken) {
  by_outcome_[{taken.visits, taken.new_visits}].push_back(agent);
}

std::vector<AgentId> TakeReport::agents() const {
  std::vector<AgentId> all;
  for (const auto& [outcome, agents] : by_outcome_) all.insert(all.end(), agents.begin(), agents.end());
  std::sort(all.begin(), all.end());
  return all;
}

std::string TakeReport::text() const {
  std::string text = method_ == TakeMethod::MERGE ? "merged into" : "replaced";
  bool first = true;
  for (const auto& [outcome, agents] : by_outcome_) {
    const std::string whose = agents.empty() ? "future agents" : namedAgents(agents);
    text += (first ? " the table of " : ", that of ") + whose + " (" + std::to_string(outcome.first) + " visits, " +
            std::to_string(outcome.second) + " of them new)";
    first = false;
  }
  return text;
}

void ShareReport::noteTaken(const std::vector<AgentId>& agents, const std::string& text) {
  taken_.insert(agents.begin(), agents.end());
  add(text);
}

void ShareReport::noteProblem(const std::string& problem) {
  is_fine_ = false;
  add(problem);
}

std::string ShareReport::text() const { return text_.empty() ? "there is no other agent" : text_; }

}  // namespace crowd
