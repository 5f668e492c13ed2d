#pragma once

#include <cstddef>
#include <cstdint>

#include "social_crowd/avoidance/candidate_move.h"
#include "social_crowd/world/perception.h"
#include "social_crowd/world/span.h"

namespace crowd {

/// @brief An agent that is to choose: what it perceives, and where that is kept which it chooses by.
struct DecisionContext {
  Perception seen;
  MoveBlock* moves = nullptr;     ///< what the actions mean to it; nullptr if nobody looks at them
  std::uint32_t* rows = nullptr;  ///< of the Q-table, that it looks its actions up in; nothing to avoidance
};

/// @brief So many agents choose side by side at most.
constexpr std::size_t MAX_BATCH = 16;

/// @brief Agents that choose side by side: each step is done for all of them before the next one is begun. That is
/// faster than one agent after the other, whose long chains of steps the processor would have to wait for.
using DecisionBatch = Span<DecisionContext>;

}  // namespace crowd
