#pragma once

#include "scenario/scene.h"
#include "world/world.h"

namespace crowd {

/// @brief Velocity of an agent of a source when it appears, `map` [m/s]: a person with mass enters walking, towards a
/// goal that it sees, at most as fast as it can stop within the free space before it. Without motion limits it stands.
Vector2 entryVelocity(const AgentStart& start, const World& world);

}  // namespace crowd
