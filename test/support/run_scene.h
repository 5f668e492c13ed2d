#pragma once

#include "simulation/episode_runner.h"

namespace crowd {

/// @brief Runs an episode of a scene to its end.
inline EpisodeResult runScene(const Scene& scene, std::uint64_t number, Learner& learner) {
  Episode episode(scene, number, learner.model().vision());
  CrowdDecider decider(learner);
  return runEpisode(episode, decider);
}

}  // namespace crowd
