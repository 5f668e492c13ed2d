#pragma once

#include <cstdint>
#include <string>

#include "social_crowd/simulation/episode_result.h"

namespace crowd {

/// @brief Header of a record. Each row holds the results of one agent in one episode, with the units of AgentResult;
/// `arrived`, `touched` and `collided` are 1 or 0.
constexpr const char* RECORD_HEADER =
    "episode,scenario,agent,arrived,touched,collided,blocked_moves,ticks,path_length,path_ratio,time_ratio,turn_per_"
    "metre,"
    "distance_gained,gain_per_tick,path_per_gain\n";

/// @brief Appends a row for each agent that was not removed.
void appendRecordRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows);

}  // namespace crowd
