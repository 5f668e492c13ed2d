#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "avoidance/perception_batch.h"
#include "world/perception.h"

namespace crowd {

/// @brief Part of each gap that no agent uses, so that rounding in the frames of two agents never makes their shares
/// add up to more than the gap [m].
constexpr double GAP_MARGIN = 1e-9;

/// @brief Number of neighbours that the kernels for near ones examine per call.
constexpr std::size_t NEIGHBOURS_AT_ONCE = 16;
static_assert(NeighbourList::PADDING >= NEIGHBOURS_AT_ONCE, "kernels read beyond the last neighbour");
/// @brief Subset of NEIGHBOURS_AT_ONCE neighbours: bit i stands for neighbour first + i.
using NeighbourSet = std::uint32_t;
/// @brief The lowest bit of a set that is not empty.
inline std::size_t lowestOf(NeighbourSet set) { return static_cast<std::size_t>(__builtin_ctz(set)); }

/// @brief Returns the neighbours first .. first + NEIGHBOURS_AT_ONCE - 1 (as far as they exist) that, if they are
/// agents, are near enough for the separation rule to limit a move of one tick at full speed. Obstacles are tested as
/// if they were agents. Conservative: because of rounding, a neighbour that limits no move may be included.
NeighbourSet findNear(const Perception& seen, std::size_t first);

/// @brief A pair of a deciding agent and a near neighbour.
struct NearAgent {
  std::uint32_t number;  ///< index of the agent * NEIGHBOURS_AT_ONCE + index of the neighbour
  /// @brief Index of the deciding agent in the batch.
  std::size_t agent() const { return number / NEIGHBOURS_AT_ONCE; }
  /// @brief Index of the neighbour in the perception of that agent.
  std::size_t neighbour() const { return number % NEIGHBOURS_AT_ONCE; }
};

/// @brief List of all near neighbours, as findNear() defines them, of the agents of a batch.
class NearAgents {
 public:
  static constexpr std::size_t MAX_COUNT = MAX_BATCH * NEIGHBOURS_AT_ONCE;

  /// @brief Considers only agents whose perceptions isFor() accepts.
  /// @param batch at most MAX_BATCH agents
  explicit NearAgents(const PerceptionBatch& batch);

  /// @brief Whether the perception holds 1 to NEIGHBOURS_AT_ONCE neighbours, all of them agents.
  static bool isFor(const Perception& seen) {
    return !seen.neighbours.empty() && seen.neighbours.size() <= NEIGHBOURS_AT_ONCE && !seen.neighbours.hasObstacles();
  }

  /// @brief Ordered by agent, then by neighbour, nearest first.
  const NearAgent* begin() const { return list_.data(); }
  const NearAgent* end() const { return list_.data() + count_; }

 private:
  std::array<NearAgent, MAX_COUNT> list_;
  std::size_t count_ = 0;
};

}  // namespace crowd
