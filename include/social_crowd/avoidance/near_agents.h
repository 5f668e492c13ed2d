#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "social_crowd/avoidance/decision_context.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Left free of every gap, so that what two agents work out in their own frames never adds up to more than it
/// [m].
constexpr double GAP_MARGIN = 1e-9;

/// @brief Bodies are looked at so many at a time.
constexpr std::size_t NEIGHBOURS_AT_ONCE = NeighbourList::MARGIN;
/// @brief Some of so many neighbours: bit i stands for neighbour first + i.
using NeighbourSet = std::uint32_t;

/// @brief Those of up to NEIGHBOURS_AT_ONCE neighbours which, as agents, are so near that the separation rule may leave
/// less of a move than the longest displacement of a tick; perhaps one too many.
NeighbourSet findNear(const Perception& seen, std::size_t first);

/// @brief An agent that is near another one that is to choose.
struct NearAgent {
  std::uint32_t number;
  std::size_t context() const { return number / NEIGHBOURS_AT_ONCE; }
  std::size_t neighbour() const { return number % NEIGHBOURS_AT_ONCE; }
};

/// @brief All that findNear() finds for agents that choose side by side.
class NearAgents {
 public:
  static constexpr std::size_t MOST = MAX_BATCH * NEIGHBOURS_AT_ONCE;

  /// @brief Looks at those that see agents alone, no more than NEIGHBOURS_AT_ONCE, see isFor(); leaves out the others.
  /// @param contexts MAX_BATCH at most
  explicit NearAgents(const DecisionBatch& contexts);

  /// @brief Whether there are neighbours to be looked at, and no others.
  static bool isFor(const Perception& seen) {
    return !seen.neighbours.empty() && seen.neighbours.size() <= NEIGHBOURS_AT_ONCE && seen.isOfAgentsAlone();
  }

  /// @brief By agent that is to choose, nearest first.
  const NearAgent* begin() const { return list_.data(); }
  const NearAgent* end() const { return list_.data() + count_; }

 private:
  std::array<NearAgent, MOST> list_;
  std::size_t count_ = 0;
};

}  // namespace crowd
