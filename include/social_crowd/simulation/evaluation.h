#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/simulation/episode_result.h"
#include "social_crowd/world/scenario.h"

namespace crowd {

/// @brief How to evaluate.
struct EvaluationPlan {
  std::uint64_t episodes = 0;  ///< 0: every document of the scenario file once
  std::uint64_t seed = 1;      ///< for placements at random, and for ties that are broken at random
  unsigned threads = 1;        ///< results do not depend on it
  bool record = false;         ///< whether trajectories are wanted
  bool scenes = false;         ///< whether scenes are wanted
  bool states = false;         ///< whether records of states are wanted
};

/// @brief What an episode of an evaluation brought.
struct EvaluatedEpisode {
  std::uint64_t instance = 0;
  EpisodeResult result;
  std::string trajectory;  ///< rows for TrajectoryFile, if wanted
  std::string states;      ///< rows below STATE_RECORD_HEADER, if wanted
  std::string scene;       ///< what it began with, as a document of a scenario file, if wanted
};

/// @brief Walks scenarios with a Q-table in demo mode. `deliver` is called once an episode, in order of the instances,
/// one call at a time; it returns whether to go on.
void evaluate(const TrainedTable& trained, const ScenarioList& scenarios, const EvaluationPlan& plan,
              const std::function<bool(EvaluatedEpisode&)>& deliver);

}  // namespace crowd
