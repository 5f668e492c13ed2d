#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "common/stop_request.h"
#include "learning/learner.h"
#include "learning/q_table_file.h"
#include "scenario/scenario.h"
#include "simulation/episode.h"
#include "simulation/episode_result.h"
#include "simulation/evaluation/tick_recorder.h"

namespace crowd {

/// @brief Settings of an evaluation.
struct EvaluationPlan {
  std::uint64_t episodes = 0;        ///< 0: each document of the scenario file once
  std::uint64_t first = 0;           ///< number of the first episode, so that any one can be repeated alone
  std::uint64_t seed = 1;            ///< for random placements and random tie-breaking
  unsigned threads = 1;              ///< results do not depend on it
  bool record = false;               ///< whether to write trajectories
  std::string scenes;                ///< folder that the scenes are for (toDocument()); empty: they are not written
  bool states = false;               ///< whether to write records of states
  bool robot_series = false;         ///< whether to write time series of robots
  bool robot_log = false;            ///< whether to write logs of robots
  RobotMetricOptions robot_metrics;  ///< of all scenes
  std::string robot_controller = "none";  ///< of all robots, see makeRobotController()
  /// Whether each episode with robots is run again without them (measurePeopleDelay()). Then episodes also last until
  /// the people have arrived, whatever the scenario's `ends`.
  bool people_delay = false;
  /// Called at the start of each episode whose ways are a problem (EpisodeResult::wayWarning()), never concurrently but
  /// on any of the threads, and in any order. Empty: nothing is called.
  std::function<void(std::uint64_t instance, const std::string& warning)> warn;
  StopRequest stop;  ///< ends the evaluation early; unfinished episodes are no part of the results

  /// @brief Calls `warn` if the ways of an episode are a problem.
  void warnOfWays(const Episode& episode) const;
};

/// @brief Output of one episode of an evaluation.
struct EvaluatedEpisode {
  std::uint64_t instance = 0;
  EpisodeResult result;
  TickRecorder::Records ticks;  ///< as far as requested
  std::string states;           ///< rows below STATE_RECORD_HEADER, if requested
  std::string scene;            ///< initial scene as a document of a scenario file, if requested
};

/// @brief A learner in demo mode with this table, for all agents.
Learner makeDemoLearner(const TrainedTable& trained, std::uint64_t seed);

/// @brief Runs scenarios with a Q-table in demo mode.
/// @param deliver called once per episode, in the order of the instances, never concurrently but on any of the threads;
/// returns whether to continue
/// @return false if the plan's stop request or `deliver` ended it early
/// @throws whatever an episode or `deliver` throws
bool evaluate(const TrainedTable& trained, const ScenarioList& scenarios, const EvaluationPlan& plan,
              const std::function<bool(EvaluatedEpisode&)>& deliver);

}  // namespace crowd
