#pragma once

#include <cstdint>
#include <string>

#include "social_crowd/learning/learner.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief First line of a record of states. A row tells what one decision rested on: where the agent was [m, `map`],
/// its heading [degrees], the row of the Q-table and the action that were chosen, and the occupied sectors,
/// counterclockwise from straight ahead, as FROM:TO:CLASS [degrees, agent frame] with blanks between them.
constexpr const char* STATE_RECORD_HEADER = "instance,tick,agent,x,y,heading,row,action,occupied\n";

/// @brief Appends a row for each agent that decides on these perceptions in demo mode.
void appendStateRows(std::uint64_t instance, const Perceptions& perceptions, const Learner& learner, std::string& rows);

}  // namespace crowd
