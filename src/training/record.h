#pragma once

#include <cstdint>
#include <string>

#include "training/training_state.h"

namespace crowd {

/// @brief Header of a record. Each row holds the results of one agent in one episode, with the units of AgentResult;
/// `arrived`, `touched` and `collided` are 1 or 0.
std::string recordHeader();

/// @brief Appends a row for each agent that was not removed.
void appendRecordRows(std::uint64_t episode, const EpisodeResult& result, std::string& rows);

/// @brief Share of the expected agents that arrived, 0 to 1; 1 if none is expected to arrive, NaN without agents.
double successShare(const EpisodeResult& result);
/// @brief Share of all agents that were in contact, 0 to 1; NaN without agents.
double contactShare(const EpisodeResult& result);

/// @brief Header of the log of a training. Each row holds one episode: number of agents; the shares of the expected
/// agents that arrived, and of all agents that were in contact and in collision, 0 to 1; mean reward of a decision,
/// rows with visits, epsilon, and number of decisions as in LearnedEpisode.
constexpr const char* LOG_HEADER =
    "episode,scenario,agents,success,contact,collision,reward,visited_rows,epsilon,decisions\n";

/// @brief Appends the row of an episode; numbers are read back bit for bit.
void appendLogRow(std::uint64_t episode, const LearnedEpisode& learned, std::string& rows);

}  // namespace crowd
