#pragma once

#include "scenario/population_spec.h"
#include "world/world.h"

namespace crowd {

/// @brief Turns an agent that stands, by at most what a person turns in a tick (180 degrees a second, or the turn rate
/// of the motion limits if that is less). The heading of an agent at rest is only the frame of its perception. Does
/// nothing while it still brakes, and if there is no such robot.
void turnTowards(const FacingDescription& face, AgentId id, World& world);
/// @brief The same towards a place [m], `map`.
void turnTowards(const Vector2& place, AgentId id, World& world);

}  // namespace crowd
