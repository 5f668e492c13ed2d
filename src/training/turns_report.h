#pragma once

#include <cstdint>
#include <string>

#include "training/communicator.h"

namespace crowd {

/// @brief Sums over the turns of a training on one rank, by the wall clock.
struct TurnTimes {
  std::uint64_t turns = 0;
  double seconds = 0.0;           ///< of whole turns
  double episode_seconds = 0.0;   ///< of the episodes of this rank's learners
  double exchange_seconds = 0.0;  ///< merging, and exchange between ranks, without the wait for the others' episodes
  std::uint64_t bytes = 0;        ///< that this rank has sent
};

/// @brief How long the turns of a training took on all ranks, and what they exchanged.
struct TurnsReport {
  int ranks = 1;
  std::uint64_t learners = 0;
  std::uint64_t turns = 0;
  double seconds = 0.0;           ///< of all turns, slowest rank
  double episode_seconds = 0.0;   ///< of their episodes, slowest rank
  double exchange_seconds = 0.0;  ///< of merging and exchange, slowest rank
  double imbalance = 1.0;         ///< of the time of the episodes: slowest rank / mean
  std::uint64_t bytes = 0;        ///< sent by all ranks

  /// @brief "2 ranks, 16 learners, 40 turns: 12.10 ms per turn (...), 0.480 MB exchanged per turn, ..."
  std::string text() const;
};

/// @brief Combines the times of all ranks; collective. @param learners number of all learners
TurnsReport reportOf(Communicator& communicator, const TurnTimes& times, std::uint64_t learners);

}  // namespace crowd
