#pragma once

#include <vector>

#include "avoidance/gap_sharing.h"
#include "avoidance/move_limit.h"
#include "world/perception.h"

namespace crowd {

/// @brief Upper bound of where an agent with motion limits stops, in one direction, agent frame; if it `is_sudden`, of
/// where it is after the tick.
struct BrakingLimit : MoveLimit {
  bool is_sudden = false;
};

/// @brief The limits of the moves of one agent, see BrakingRule.
using BrakingLimits = std::vector<BrakingLimit>;

/// @brief Finds the limits of an agent with motion limits that it can come up to within a tick at its maximum speed.
/// @param limits output; what it held before is removed
void findBrakingLimits(const Perception& seen, GapSharing sharing, BrakingLimits& limits);

}  // namespace crowd
