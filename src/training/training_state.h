#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "learning/rl/q_table.h"
#include "simulation/episode_result.h"
#include "world/perception.h"

namespace crowd {

/// @brief An episode of a training: its result, and what was learned in it.
struct LearnedEpisode : EpisodeResult {
  std::uint64_t decisions = 0;  ///< that were learned from
  double reward = 0.0;          ///< mean reward of these decisions; NaN without any
  double epsilon = 0.0;         ///< probability of a random action
  /// Rows of the learner's table with visits, after the episode; with own tables, of the table of agent 0. 0 unless
  /// Training::countVisitedRows() was called.
  Row visited_rows = 0;
};

/// @brief All that the episodes of a training leave to the next one. Random numbers depend only on the seed and on the
/// numbers of episode, tick and agent, so that they need no state.
struct TrainingState {
  std::uint64_t episode = 0;                  ///< number of completed episodes
  std::uint64_t decisions_before = 0;         ///< of the table that the training began with
  std::vector<std::uint64_t> decisions;       ///< by learner
  std::vector<std::vector<double>> headings;  ///< by learner: of the agents at the end of its last episode [rad]
  QTable table;                               ///< of all learners; with own tables, that of new agents
  std::map<AgentId, QTable> own;              ///< own tables that differ from it
};

}  // namespace crowd
