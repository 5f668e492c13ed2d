#pragma once

#include <cstdint>
#include <vector>

#include "learning/learner.h"
#include "simulation/decider.h"
#include "world/perceiver.h"

namespace crowd {

/// @brief One learner decides for all agents, until the episode is over.
///
/// In demo mode, if all agents move at the same time, it processes blocks of spatially adjacent agents, whose
/// perceptions stay in the cache until they have decided and are then discarded. The decisions equal those of
/// Learner::decide(), with less time and memory; but they are in the order of the world's bodies, and the learner does
/// not register the agents.
class CrowdDecider final : public Decider {
 public:
  /// @param learner, thread_pool must outlive it. The threads share the agents of demo mode; the decisions do not
  /// depend on their number
  explicit CrowdDecider(Learner& learner, ThreadPool& thread_pool = ThreadPool::callerOnly())
      : learner_(learner), thread_pool_(thread_pool) {}

  /// @throws Stopped if the world's stop request is made
  bool decide(Episode& episode, std::vector<AgentAction>& actions) override;
  /// @brief The decisions of demo mode for all agents of a world. @param episode its number
  void decideInBlocks(const World& world, std::uint64_t episode, const Vision& vision,
                      std::vector<AgentAction>& actions);

 private:
  /// Workspace of one worker.
  struct ThreadWorkspace {
    Viewers viewers;
    Perceiver perceiver;
    Perceptions perceptions;
    DecisionWorkspace decision_workspace;
  };

  Learner& learner_;
  ThreadPool& thread_pool_;
  RelativeActions answers_;
  std::vector<ThreadWorkspace> workspaces_;
  std::vector<std::vector<AgentAction>> decided_;  // by block, if several workers decide
};

}  // namespace crowd
