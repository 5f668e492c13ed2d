#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "social_crowd/learning/learner.h"
#include "social_crowd/ranks/ranks_report.h"
#include "social_crowd/simulation/crowd_decider.h"
#include "social_crowd/simulation/episode.h"
#include "social_crowd/training/communicator.h"

namespace crowd {

/// @brief Decisions for an episode that every rank runs as a whole, for scenes that DistributedCrowd cannot divide.
/// Each rank decides for a part of the agents and receives the other actions. All ranks then have the same actions, so
/// that their worlds stay the same.
class SharedDecisions final : public Decider {
 public:
  /// @param learner in demo mode @param is_stopped whether this rank wants the episode to end; may be empty
  SharedDecisions(Communicator& communicator, Learner& learner, ThreadPool& thread_pool,
                  std::function<bool()> is_stopped);

  /// @brief Writes the actions of a CrowdDecider, until a rank wants the episode to end. Collective.
  bool decide(Episode& episode, std::vector<AgentAction>& actions) override;
  /// @brief In place of decide(): tells all ranks that this one has left the episode.
  void stop();
  /// @brief Whether a rank wanted an episode to end; the same on all ranks.
  bool wasStopped() const { return was_stopped_; }
  /// @brief Processor time of this rank while it waited for the others [s].
  double waitingSeconds() const { return waiting_seconds_; }
  /// @brief Bytes that this rank has sent.
  std::uint64_t sentBytes() const { return bytes_; }

 private:
  std::vector<Communicator::Bytes> gather(const Communicator::Bytes& message);
  void append(const Communicator::Bytes& message, std::vector<AgentAction>& actions);

  Communicator& communicator_;
  CrowdDecider own_;
  std::function<bool()> is_stopped_;
  bool was_stopped_ = false;
  std::uint64_t bytes_ = 0;
  double waiting_seconds_ = 0.0;
};

}  // namespace crowd
