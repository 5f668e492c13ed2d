#include "social_crowd/simulation/episode_runner.h"

namespace crowd {

EpisodeResult runEpisode(Episode& episode, const Decide& decide, const EpisodeObserver& observer,
                         RobotDrivers* robots) {
  RelativeActions actions;
  bool begins_tick = true;
  for (;;) {
    if (begins_tick && observer.on_tick) observer.on_tick(episode.world());
    if (observer.on_turn && !episode.isOver()) observer.on_turn(episode.perceptions());
    decide(episode, actions);
    if (episode.isOver() || (observer.is_stopped && observer.is_stopped())) return episode.result();
    if (begins_tick && robots != nullptr) robots->command(episode);
    begins_tick = episode.step(actions.agents);
  }
}

EpisodeResult runEpisode(Episode& episode, Learner& learner, const EpisodeObserver& observer, RobotDrivers* robots) {
  const auto decide = [&](Episode& walked, RelativeActions& actions) { walked.decide(learner, actions); };
  return runEpisode(episode, decide, observer, robots);
}

}  // namespace crowd
