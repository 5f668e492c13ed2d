#pragma once

#include "social_crowd/world/world.h"

namespace crowd {

/// @brief The wanted twist of a robot that yields, slowed down so that it can stop before it touches anybody: on the
/// arc of the twist, at its greatest deceleration, and as if every agent on its way came towards it at full speed for a
/// tick. Once it stands still it stays until its way is free for a tick.
Twist protectiveTwist(const Robot& robot, const World& world);

}  // namespace crowd
