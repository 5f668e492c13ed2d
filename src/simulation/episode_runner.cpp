#include "simulation/episode_runner.h"

namespace crowd {

EpisodeResult runEpisode(Episode& episode, Decider& decider, const EpisodeObserver& observer, RobotDrivers* robots) {
  do {
    if (episode.beginsTick() && observer.on_tick) observer.on_tick(episode.world());
    if (episode.isOver()) continue;
    if (observer.on_turn) observer.on_turn(episode.perceptions());
    if (episode.beginsTick() && robots != nullptr) robots->command(episode);
  } while (episode.walk(decider));
  return episode.result();
}

}  // namespace crowd
