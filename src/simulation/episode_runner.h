#pragma once

#include <functional>

#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "simulation/robot_controller.h"

namespace crowd {

/// @brief Functions that runEpisode() calls; empty ones are skipped.
struct EpisodeObserver {
  std::function<void(const World&)> on_tick;        ///< at the start of each tick, and at the end of the episode
  std::function<void(const Perceptions&)> on_turn;  ///< before the decisions of each turn
};

/// @brief Runs an episode until Episode::walk() returns false.
/// @param robots command the robots before each tick; null: the robots get no commands
EpisodeResult runEpisode(Episode& episode, Decider& decider, const EpisodeObserver& observer = {},
                         RobotDrivers* robots = nullptr);

}  // namespace crowd
