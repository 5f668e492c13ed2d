#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "social_crowd/learning/learner.h"
#include "social_crowd/ranks/ranks_report.h"
#include "social_crowd/simulation/episode.h"
#include "social_crowd/training/communicator.h"

namespace crowd {

/// @brief Decisions for an episode that every rank runs as a whole, for scenes that DistributedCrowd cannot divide.
/// Each rank decides for a part of the agents and receives the other actions. All ranks then have the same actions, so
/// that their worlds stay the same.
class SharedDecisions {
 public:
  /// @param learner in demo mode @param is_stopped whether this rank wants the episode to end; may be empty
  SharedDecisions(Communicator& communicator, Learner& learner, std::function<bool()> is_stopped)
      : communicator_(communicator), learner_(learner), is_stopped_(std::move(is_stopped)) {}

  /// @brief Writes the actions of Episode::decide(). Collective.
  void decide(Episode& episode, RelativeActions& actions);
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
  Learner& learner_;
  std::function<bool()> is_stopped_;
  bool was_stopped_ = false;
  std::uint64_t bytes_ = 0;
  double waiting_seconds_ = 0.0;
};

}  // namespace crowd
