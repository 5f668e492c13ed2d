#pragma once

#include <cstddef>
#include <cstdint>

#include "social_crowd/avoidance/candidate_move.h"
#include "social_crowd/world/perception.h"
#include "social_crowd/world/span.h"

namespace crowd {

/// @brief Inputs and buffers of one agent's decision. The caller owns the buffers; they are valid during the call that
/// receives the context.
struct DecisionContext {
  Perception seen;                ///< perception of the agent, limited to the vision of the model
  MoveBlock* moves = nullptr;     ///< the move of each action; nullptr if the state set does not need the moves
  std::uint32_t* rows = nullptr;  ///< rows of the Q-table that the state set writes; unused in avoidance
};

/// @brief Maximum number of agents in a DecisionBatch.
constexpr std::size_t MAX_BATCH = 16;

/// @brief Agents whose decisions are computed together: each step is done for all agents before the next step begins.
/// The steps of one agent depend on each other; those of different agents overlap in the processor.
using DecisionBatch = Span<DecisionContext>;

}  // namespace crowd
