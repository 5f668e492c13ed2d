#include "social_crowd/simulation/episode_runner.h"

namespace crowd {

EpisodeResult runEpisode(Episode& episode, Learner& learner, const EpisodeObserver& observer, RobotDrivers* robots) {
  RelativeActions actions;
  bool begins_tick = true;
  for (;;) {
    if (begins_tick && observer.on_tick) observer.on_tick(episode.world());
    if (observer.on_turn && !episode.isOver()) observer.on_turn(episode.perceptions());
    episode.decide(learner, actions);
    if (episode.isOver()) return episode.result();
    if (begins_tick && robots != nullptr) robots->command(episode);
    begins_tick = episode.step(actions.agents);
  }
}

}  // namespace crowd
