#pragma once

#include <algorithm>

#include "common/text/enum_names.h"
#include "world/perception.h"

namespace crowd {

/// @brief How two agents that move at the same time share the gap between their bodies, or stopping regions.
enum class GapSharing {
  NONE,    ///< no rule: moves are not limited
  HALF,    ///< each agent may use half of the gap
  MOVING,  ///< the line between them moves with their mean velocity: a follower may use the space that a leader leaves
};

inline constexpr EnumNames<GapSharing, 3> GAP_SHARINGS{"gap_sharing", {"none", "half", "moving"}};

/// @brief By how much the share of an agent in a gap exceeds the half: the line that divides the gap moves with the
/// mean of both last velocities, but stays within the gap [m].
/// @param gap its width [m] @param normal unit vector towards the other
inline double shiftOfLine(double gap, const Vector2& normal, const Perception& seen, const Neighbour& other) {
  const double shift = 0.5 * seen.tick_duration * normal.dot(seen.self.velocity + other.velocity);
  return std::clamp(shift, -0.5 * gap, 0.5 * gap);
}

/// @brief What a robot needs of the gap to an agent, as far as it comes nearer in the tick: it may move on as it does,
/// or stop, but not come nearer than that [m].
/// @param normal unit vector towards the robot
inline double needOfRobot(const Vector2& normal, const Perception& seen, const Neighbour& robot) {
  return std::max(0.0, -seen.tick_duration * normal.dot(robot.velocity));
}

}  // namespace crowd
