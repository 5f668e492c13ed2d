#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "social_crowd/q_table.h"
#include "social_crowd/results.h"
#include "social_crowd/scenario.h"

namespace crowd::library {

struct EvaluationOptions {
  std::uint64_t episodes = 0;  ///< 0: each document of the scenario once
  std::uint64_t seed = 1;      ///< of drawn places and random decisions
  unsigned threads = 0;        ///< 0: one per processor; results do not depend on it
  /// Of all robots: none (they stand), straight, reactive or learned (docs/robots.md).
  std::string robot_controller = "none";
  /// Called after each episode, in their order, on any thread but never at the same time; returns whether to go on.
  std::function<bool(const EpisodeResult& result)> on_episode;
};

/// @brief Means over episodes, as the program `evaluate` prints them; NaN where there is nothing to count.
struct Means {
  std::uint64_t episodes = 0;
  double success_percent = 0.0;    ///< agents that arrived, of those that were to; NaN if nobody was
  double contact_percent = 0.0;    ///< agents whose bodies overlapped another one or a wall
  double collision_percent = 0.0;  ///< agents that had one within their collision radius (thesis, 4.1)
  double clean_percent = 0.0;      ///< episodes in which all arrived and none was in contact
  double path_ratio = 0.0;         ///< path / straight line, of the agents that arrived
  double time_ratio = 0.0;         ///< time / time on the straight line at maximum speed, of these
  double turn_per_metre = 0.0;     ///< accumulated change of direction [rad/m], of these
  double max_speed_ratio = 0.0;    ///< highest speed of an agent / its maximum speed
  double blocked_moves = 0.0;      ///< per agent
};

/// @brief Runs episodes of a scenario in which all agents decide greedily. Returns when all threads are done.
/// @return means over the episodes that were delivered to `on_episode`
/// @throws InputError as Episode does, or if there is no such controller; whatever `on_episode` throws
Means evaluate(const QTable& table, const Scenario& scenario, const EvaluationOptions& options = {});

}  // namespace crowd::library
