#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "social_crowd/learning/learner.h"
#include "social_crowd/world/perceiver.h"

namespace crowd {

/// @brief Greedy decisions for all agents of a world. It processes blocks of spatially adjacent agents, whose
/// perceptions stay in the cache until they have decided and are then discarded. The decisions equal those of
/// a Perceiver for all agents and Learner::decide() in demo mode, with less time and memory.
class GreedyCrowd {
 public:
  /// @param episode its number; with the tick it seeds random tie-breaking
  /// @param actions is overwritten; in the order of the world's bodies
  /// @param thread_pool its threads share the agents; the decisions do not depend on their number
  /// @param names of the world's agents, by their id, by which a learner that serves all agents knows them; null: their
  /// ids
  /// @throws Stopped if the world's stop request is made
  void decide(const World& world, std::uint64_t episode, const Vision& vision, const Learner& learner,
              std::vector<AgentAction>& actions, ThreadPool& thread_pool = ThreadPool::callerOnly(),
              const std::vector<AgentId>* names = nullptr);

 private:
  /// Workspace of one worker.
  struct ThreadWorkspace {
    Viewers viewers;
    Perceiver perceiver;
    Perceptions perceptions;
    DecisionWorkspace decision_workspace;
    std::vector<AgentId> ids;  // of the agents of a block, if they have names
  };
  static void decideBlock(const Learner& learner, const std::vector<AgentId>* names, ThreadWorkspace& workspace,
                          std::vector<AgentAction>& actions);

  std::vector<ThreadWorkspace> workspaces_;
  std::vector<std::vector<AgentAction>> decided_;  // by block, if several workers decide
};

}  // namespace crowd
