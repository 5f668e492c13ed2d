#pragma once

#include "scenario/placed_bodies.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Places the robots of a scenario whose positions are fixed, or those whose positions are drawn.
/// @param fixed which of these @param random their own stream, so that what else is drawn does not depend on robots
/// @param placed gets the smallest discs that contain them
/// @throws InputError, with file, document and line, if a robot overlaps something, does not fit at its goal, starts at
/// its goal, or if no free place is found
void placeRobots(const Scenario& scenario, bool fixed, KeyedRandom& random, PlacedBodies& placed, Scene& scene);

}  // namespace crowd
