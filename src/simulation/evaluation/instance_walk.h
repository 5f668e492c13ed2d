#pragma once

#include <cstdint>
#include <functional>

#include "simulation/episode_runner.h"
#include "simulation/evaluation/evaluation.h"

namespace crowd {

/// How the instances of an evaluation are run.
struct InstanceWalk {
  const EvaluationPlan& plan;
  Learner& learner;
  ThreadPool& thread_pool;
  Decider& decider;
  std::function<void(const Episode&)> begin;  ///< called at the start of an episode
  /// Called at the start of each tick, also without robots, and at the end; may be empty.
  std::function<void(const World&)> on_tick;

  /// Runs an episode, and what the plan requests with it. @throws Stopped if the plan's stop request is made
  EvaluatedEpisode run(Scene scene, std::uint64_t instance) const;

 private:
  EvaluatedEpisode walk(Episode& episode) const;
};

}  // namespace crowd
