#pragma once

#include "simulation/episode_result.h"

namespace crowd {

/// @brief Measures what the robots of an episode cost people, against the same episode without robots: the mean
/// differences of time and path length, with robots minus without, of the people that arrived in both episodes. An
/// agent is the same person if its number, the tick at which it appeared and the place where it appeared are the same.
/// @param tick_duration [s] @param with gets the fields `people_...` of all its robots
void measurePeopleDelay(const EpisodeResult& without, double tick_duration, EpisodeResult& with);

}  // namespace crowd
