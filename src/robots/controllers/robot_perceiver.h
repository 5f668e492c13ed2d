#pragma once

#include <cstdint>

#include "robots/controllers/robot_way.h"
#include "world/perceiver.h"

namespace crowd {

/// @brief What planners see that have no limits of their own: all that is visible within 6 m, and walls within 3 m.
inline constexpr Vision PLANNER_VISION{6.0, 0, true, 3.0};

/// @brief What a robot that knows the floor plan perceives: what an agent at its place perceives
/// (Viewers::inPlaceOf()), with the next point of its way round walls as the goal. One object for each robot.
class RobotPerceiver {
 public:
  /// @param episode its number @param finds_ways whether ways lead round walls, as agents do with way-finding; else
  /// straight to the goal
  RobotPerceiver(std::uint64_t episode, bool finds_ways) : finds_ways_(finds_ways) { perceptions_.episode = episode; }

  /// @brief The perception of the robot alone, number 0, in its frame, until the next call; call it once a tick.
  /// @param goal [m], `map`
  const Perceptions& perceive(const World& world, const Vision& vision, RobotId id, const Vector2& goal);

 private:
  bool finds_ways_;
  RobotWay way_;
  Viewers viewers_;
  Perceiver perceiver_;
  Perceptions perceptions_;
};

/// @brief The velocity to the goal of a perception [m/s], in its frame: at the maximum speed, slower in the last metre.
/// @param goal of the robot [m], `map`; that of the perception is on the way to it
Vector2 wantedVelocity(const AgentPerception& self, const Vector2& goal);

}  // namespace crowd
