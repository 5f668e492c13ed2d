#pragma once

#include <vector>

#include "learning/states/state_set.h"

namespace crowd {

/// @brief The rows that a state set finds for one perception.
/// @param moves candidate moves of the agent, if the state set reads them
inline std::vector<Row> rowsOf(const StateSet& states, const Perception& seen,
                               const std::vector<MoveBlock>& moves = {}) {
  std::vector<Row> rows(states.rowsPerPerception());
  states.findRows({&seen, 1}, moves.data(), rows.data());
  return rows;
}

}  // namespace crowd
