#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "learning/agent_share.h"
#include "world/perception.h"

namespace crowd {

/// @brief Indices of agents in Perceptions::agents, ascending.
using PerceptionRows = std::vector<std::uint32_t>;

/// @brief The topics on which learners receive the perceptions of their agents only. If several learners claim a topic,
/// it contains the agents of all of them.
class PerceptionRoutes {
 public:
  /// @brief Records the claim of a learner, in place of its previous one.
  /// @param topic empty: the learner claims none
  /// @param agents in any order; repeated ones count once
  /// @param share if it is not the whole, of all agents, in place of `agents`
  /// @return whether the claims have changed
  bool claim(const std::string& learner, const std::string& topic, const std::vector<AgentId>& agents,
             const AgentShare& share = {});

  /// @brief Returns the claimed topics, in alphabetical order.
  const std::vector<std::string>& topics() const { return topics_; }
  /// @brief Returns the agents of each topic that are perceived, in the order of topics().
  std::vector<PerceptionRows> split(const Perceptions& perceptions) const;
  /// @brief Returns the agents of one topic that are perceived.
  PerceptionRows rowsOf(const std::string& topic, const Perceptions& perceptions) const;

 private:
  struct Claim {
    std::string topic;
    std::set<AgentId> agents;
    AgentShare share;
  };
  struct Route {
    AgentId agent;
    std::uint32_t topic;  // index in topics_
  };
  struct ShareRoute {
    AgentShare share;
    std::uint32_t topic = 0;  // index in topics_
  };
  void update();

  std::map<std::string, Claim> claims_;  // by learner
  std::vector<std::string> topics_;
  std::vector<Route> routes_;  // by agent, then by topic; none twice
  std::vector<ShareRoute> shares_;
};

}  // namespace crowd
