#pragma once

#include "common/stop_request.h"
#include "scenario/placed_bodies.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief How the position of an obstacle is determined. BETWEEN: drawn on the way of an agent.
enum class ObstaclePosition { FIXED, DRAWN, BETWEEN };

/// @brief Places those obstacles of a scenario whose positions are determined in one of these ways.
/// @param placed gets them @param scene its agents must have been placed before the obstacles on their ways
/// @throws InputError, with file, document and line, if no free place is found; Stopped
void placeObstacles(const Scenario& scenario, ObstaclePosition position, KeyedRandom& random, const StopRequest& stop,
                    PlacedBodies& placed, Scene& scene);

}  // namespace crowd
