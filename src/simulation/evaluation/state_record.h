#pragma once

#include <cstdint>
#include <string>

#include "learning/learner.h"
#include "world/perception.h"

namespace crowd {

/// @brief Header of a record of states. Each row describes one decision: position of the agent [m, `map`], heading
/// [degrees], row of the Q-table, chosen action, and the occupied sectors, counterclockwise from straight ahead, as
/// FROM:TO:CLASS [degrees, agent frame], separated by blanks.
constexpr const char* STATE_RECORD_HEADER = "instance,tick,agent,x,y,heading,row,action,occupied\n";

/// @brief Appends a row for the greedy decision of each agent of these perceptions that has not arrived; no row if
/// `last` is set.
void appendStateRows(std::uint64_t instance, const Perceptions& perceptions, const Learner& learner, std::string& rows);

}  // namespace crowd
