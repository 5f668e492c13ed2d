#pragma once

#include <cstdint>
#include <string>

#include "training/communicator.h"

namespace crowd {

/// @brief How well the ranks worked together in an episode; the same on all ranks.
struct RanksReport {
  int ranks = 1;
  std::uint64_t agents = 0;  ///< of all ranks, with those of sources
  std::uint64_t ticks = 0;
  double seconds = 0.0;             ///< of all ticks, on the wall
  std::uint64_t bytes = 0;          ///< sent by all ranks in these ticks
  double busy_seconds = 0.0;        ///< processor time of the slowest rank, without waiting for others
  bool is_divided = true;           ///< whether each rank has a part of the floor; else rank 0 walks alone
  double agent_imbalance = 1.0;     ///< agents of the largest share / mean, averaged over the divisions of the floor
  double time_imbalance = 1.0;      ///< computing time of the slowest rank / mean, without waiting for others
  std::uint64_t whole_motions = 0;  ///< ticks in which each rank computed the motion of the whole solid crowd

  /// @brief Sets the fields that all ranks have a part in. Collective.
  /// @param own_busy_seconds processor time of this rank @param own_bytes sent by this rank
  void collect(Communicator& communicator, double own_busy_seconds, std::uint64_t own_bytes);

  /// @brief "2 ranks: 12.3 ms a tick, ...".
  std::string text() const;
};

}  // namespace crowd
