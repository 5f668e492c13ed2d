#pragma once

#include <optional>
#include <vector>

#include "learning/decision_values.h"
#include "learning/learner.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief What an agent perceives and would choose now, for display.
struct AgentMind {
  DecisionValues values;
  double max_speed = 0.0;           ///< [m/s]
  std::vector<AgentId> neighbours;  ///< agents that it perceives whole, ascending
};

/// @brief What an agent would choose from if it were its turn. Nothing changes. @param learner in demo mode
/// @return null if the agent does not decide
std::optional<AgentMind> mindOf(const Episode& episode, Learner& learner, AgentId agent);

}  // namespace crowd
