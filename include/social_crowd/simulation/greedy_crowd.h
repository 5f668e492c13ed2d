#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/learning/learner.h"
#include "social_crowd/world/world.h"

namespace crowd {

/// @brief Decides greedily for everybody in a world, a few neighbours at a time, whose perceptions stay in the cache
/// until they have decided and are then forgotten. The same decisions as of World::perceive() and Learner::decide() in
/// demo mode, sooner and with less memory.
class GreedyCrowd {
 public:
  /// @param episode its number; with the tick it is what chance decides by between equal values
  /// @param thread_pool its threads share out the agents; what is decided does not depend on their number
  /// @param actions is overwritten; neighbours stand one after the other
  void decide(const World& world, std::uint64_t episode, const Vision& vision, const Learner& learner,
              std::vector<AgentAction>& actions, ThreadPool& thread_pool = ThreadPool::callerOnly());

 private:
  /// What a worker needs.
  struct ThreadWorkspace {
    World::PerceptionWorkspace perception_workspace;
    Perceptions perceptions;
    Learner::DecisionWorkspace decision_workspace;
  };

  std::vector<ThreadWorkspace> workspaces_;
  std::vector<std::vector<AgentAction>> decided_;  // by block, where several workers decide
};

}  // namespace crowd
