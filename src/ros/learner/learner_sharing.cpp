// Sharing of Q-tables between the agents of a learner and between learner nodes.

#include <algorithm>
#include <map>

#include "common/text/quotes.h"
#include "ros/learner/learner_node.h"
#include "ros/messages/agent_list.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

const ros::Duration REACH(1.0);               // timeout for the service of another learner
constexpr std::size_t MOST_AGENTS = 10'000;   // that a request lists; an empty list stands for all
constexpr std::size_t MAX_MESSAGE = 100'000;  // [bytes]

bool contains(const std::vector<AgentId>& agents, AgentId agent) {
  return std::find(agents.begin(), agents.end(), agent) != agents.end();
}

/// Calls ~take_q_table of another learner. If the call fails, the response contains the cause.
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

using Learners = std::map<std::string, social_crowd::LearnerStatus>;  // by node name

/// Returns why an agent did not get the shared table.
std::string whyNotTaken(AgentId agent, AgentId from, const Learners& others) {
  const std::string name = "agent " + std::to_string(agent);
  if (agent == from) return name + " is the source";
  const bool is_served = std::any_of(others.begin(), others.end(),
                                     [&](const auto& other) { return contains(other.second.agents, agent); });
  return name + " did not get it" + (is_served ? "" : ": no learner serves agent " + std::to_string(agent));
}

}  // namespace

TakeReport LearnerNode::giveTo(const std::vector<AgentId>& agents, QTable table, TakeMethod method) {
  TakeReport report(method);
  table.beginSource();  // one source for all receiving agents
  if (!agents.empty() && learner_.tables().use() == TableUse::OWN) {
    for (const AgentId agent : agents) report.note(agent, learner_.tables().take(agent, table, method));
    return report;
  }
  const AgentTables::TakenByAll taken = learner_.tables().take(std::move(table), method);
  const std::vector<AgentId> served = learner_.servedAgents();
  for (const AgentId agent : served) {
    const auto own = taken.by_agent.find(agent);
    report.note(agent, own != taken.by_agent.end() ? own->second : taken.newcomers);
  }
  if (served.empty()) report.noteNewcomers(taken.newcomers);
  return report;
}

void LearnerNode::take(const social_crowd::TakeQTable::Request& request, social_crowd::TakeQTable::Response& response) {
  requireFew("to_agents", request.to_agents.size(), MOST_AGENTS);
  const std::string name = "the shared Q-table";
  const TrainedTable trained = parseQTable(request.q_table, name, &learner_.model());
  const TakeMethod method = request.method.empty() ? on_share_ : TAKE_METHODS.parse(request.method);
  loop_.ask<void>([&] {
    for (const AgentId agent : request.to_agents) requireServed(agent);
    const TakeReport report = giveTo(request.to_agents, trained.table, method);
    response.taken_by = report.agents();
    response.message = report.text();
    publishStatus();
  });
}

void LearnerNode::share(const social_crowd::ShareQTable::Request& request,
                        social_crowd::ShareQTable::Response& response) {
  requireFew("to_agents", request.to_agents.size(), MOST_AGENTS);
  const TakeMethod method = request.method.empty() ? on_share_ : TAKE_METHODS.parse(request.method);
  ShareReport report;
  AgentId from = request.from_agent;
  social_crowd::TakeQTable::Request offer;
  offer.method = request.method;
  Learners others;
  loop_.ask<void>([&] {
    from = meant(request.from_agent);
    const TrainedTable table = trained(learner_.tables().toShare(from));
    offer.q_table = toText(table);
    others = others_;
    shareWithin(request.to_agents, from, table.table, method, report);
  });
  for (const auto& [learner, status] : others) {
    offer.to_agents.clear();
    for (const AgentId agent : request.to_agents) {
      if (contains(status.agents, agent)) offer.to_agents.push_back(agent);
    }
    if (!request.to_agents.empty() && offer.to_agents.empty()) continue;
    const social_crowd::TakeQTable::Response answer = askToTake(learner, offer);
    if (answer.success != 0) {
      report.noteTaken(answer.taken_by, answer.message);
    } else {
      report.noteProblem(learner + " did not take it: " + answer.message);
    }
  }
  for (const AgentId agent : request.to_agents) {
    if (!report.isTakenBy(agent)) report.noteProblem(whyNotTaken(agent, from, others));
  }
  response.success = report.isFine();
  response.taken_by = report.takenBy();
  response.message = shortened("the Q-table of agent " + std::to_string(from) + ": " + report.text(), MAX_MESSAGE);
}

void LearnerNode::shareWithin(const std::vector<AgentId>& agents, AgentId from, const QTable& table, TakeMethod method,
                              ShareReport& report) {
  const std::vector<AgentId> served = learner_.servedAgents();
  std::vector<AgentId> mine;
  for (const AgentId agent : served) {
    const bool is_meant = agents.empty() || contains(agents, agent);
    if (is_meant && agent != from) mine.push_back(agent);
  }
  if (mine.empty()) return;
  if (learner_.tables().use() == TableUse::SHARED) {
    return report.noteTaken(served, namedAgents(served) + " share it already");
  }
  const TakeReport taken = giveTo(mine, table, method);
  report.noteTaken(taken.agents(), taken.text());
  publishStatus();
}

}  // namespace crowd
