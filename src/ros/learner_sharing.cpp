// Sharing of Q-tables between the agents of a learner and between learner nodes.

#include <algorithm>
#include <set>

#include "social_crowd/ros/learner_node.h"
#include "social_crowd/ros/names.h"

namespace crowd {
namespace {

const ros::Duration REACH(1.0);  // how long to look for another learner's service

std::string listOf(const std::vector<AgentId>& agents) {
  std::string text;
  for (const AgentId agent : agents) text += (text.empty() ? "" : ", ") + std::to_string(agent);
  return text;
}

bool contains(const std::vector<AgentId>& agents, AgentId agent) {
  return std::find(agents.begin(), agents.end(), agent) != agents.end();
}

/// Asks another learner to take a table. What went wrong is the message of a failed response.
social_crowd::TakeQTable::Response askToTake(const std::string& learner,
                                             const social_crowd::TakeQTable::Request& request) {
  social_crowd::TakeQTable call;
  call.request = request;
  const std::string service = learner + "/" + names::TAKE_Q_TABLE;
  const bool reached = ros::service::waitForService(service, REACH) && ros::service::call(service, call);
  if (reached) return call.response;
  call.response.success = 0;
  call.response.message = "cannot be reached";
  return call.response;
}

/// Who took a table and who did not.
class ShareReport {
 public:
  void noteTaken(const std::vector<AgentId>& agents) { taken_.insert(agents.begin(), agents.end()); }
  void noteProblem(const std::string& problem) { problems_ += "; " + problem; }
  bool isTakenBy(AgentId agent) const { return taken_.count(agent) > 0; }

  void writeTo(social_crowd::ShareQTable::Response& response, AgentId from) const {
    response.taken_by.assign(taken_.begin(), taken_.end());
    response.success = problems_.empty();
    const std::string who = taken_.empty() ? "nobody" : "agents " + listOf(response.taken_by);
    response.message = "the Q-table of agent " + std::to_string(from) + " was taken by " + who + problems_;
  }

 private:
  std::set<AgentId> taken_;
  std::string problems_;
};

}  // namespace

std::vector<AgentId> LearnerNode::giveTo(const std::vector<AgentId>& agents, const TrainedTable& trained,
                                         TakeMethod method) {
  if (agents.empty() || learner_.tableUse() == TableUse::SHARED) {
    learner_.takeTable(trained.table, method);
    return learner_.servedAgents();
  }
  for (const AgentId agent : agents) learner_.takeTable(agent, trained.table, method);
  return agents;
}

void LearnerNode::take(const social_crowd::TakeQTable::Request& request, social_crowd::TakeQTable::Response& response) {
  const std::string name = "the shared Q-table";
  const TrainedTable trained = parseQTable(request.q_table, name);
  const TakeMethod method = request.method.empty() ? on_share_ : parseTakeMethod(request.method);
  loop_.ask<void>([&] {
    requireFit(learner_.model(), trained.model, name);
    for (const AgentId agent : request.to_agents) requireServed(agent);
    response.taken_by = giveTo(request.to_agents, trained, method);
    publishStatus();
  });
  response.message = "taken by agents " + listOf(response.taken_by) + " (" + toText(method) + ")";
}

void LearnerNode::share(const social_crowd::ShareQTable::Request& request,
                        social_crowd::ShareQTable::Response& response) {
  if (!request.method.empty()) parseTakeMethod(request.method);
  ShareReport report;
  social_crowd::TakeQTable::Request offer;
  offer.method = request.method;
  std::map<std::string, social_crowd::LearnerStatus> others;
  loop_.ask<void>([&] {
    requireServed(request.from_agent);
    const TrainedTable table = trained(request.from_agent);
    offer.q_table = toText(table);
    others = others_;
    report.noteTaken(shareWithin(request, table));
  });
  for (const auto& [learner, status] : others) {
    offer.to_agents.clear();
    for (const AgentId agent : request.to_agents) {
      if (contains(status.agents, agent)) offer.to_agents.push_back(agent);
    }
    if (!request.to_agents.empty() && offer.to_agents.empty()) continue;
    const social_crowd::TakeQTable::Response answer = askToTake(learner, offer);
    if (answer.success != 0) {
      report.noteTaken(answer.taken_by);
    } else {
      report.noteProblem(learner + " did not take it: " + answer.message);
    }
  }
  for (const AgentId agent : request.to_agents) {
    if (!report.isTakenBy(agent)) report.noteProblem("agent " + std::to_string(agent) + " did not get it");
  }
  report.writeTo(response, request.from_agent);
}

std::vector<AgentId> LearnerNode::shareWithin(const social_crowd::ShareQTable::Request& request,
                                              const TrainedTable& table) {
  const TakeMethod method = request.method.empty() ? on_share_ : parseTakeMethod(request.method);
  std::vector<AgentId> served = learner_.servedAgents();
  std::vector<AgentId> mine;
  for (const AgentId agent : served) {
    const bool meant = request.to_agents.empty() || contains(request.to_agents, agent);
    // Merging a table into itself would count its visits twice.
    if (meant && agent != request.from_agent) mine.push_back(agent);
  }
  if (mine.empty() && !request.to_agents.empty()) return mine;
  if (learner_.tableUse() == TableUse::SHARED) return served;  // they use it already
  for (const AgentId agent : mine) learner_.takeTable(agent, table.table, method);
  publishStatus();
  return mine;
}

}  // namespace crowd
