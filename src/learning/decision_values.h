#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "avoidance/candidate_move.h"
#include "learning/rl/rows.h"

namespace crowd {

/// @brief A move that an agent could have chosen, with its entry in the Q-table.
struct ValuedMove {
  CandidateMove move;
  Row row = 0;
  double value = 0.0;        ///< unit of the reward
  std::uint32_t visits = 0;  ///< decisions that the value was learned from
};

/// @brief What an agent chose from in its last decision; made by Learner::valuesOf().
struct DecisionValues {
  std::vector<ValuedMove> moves;  ///< by action
  Action chosen = 0;

  /// @brief Whether the agent explored: another move has a higher value than the chosen one.
  bool isExploration() const {
    return std::any_of(moves.begin(), moves.end(),
                       [&](const ValuedMove& other) { return other.value > moves[chosen].value; });
  }
};

}  // namespace crowd
