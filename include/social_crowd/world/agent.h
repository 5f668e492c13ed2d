#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/geometry/geometry.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief WALKING: on its way. ARRIVED, REMOVED: not in the world any more.
enum class AgentStatus : std::uint8_t { WALKING = 0, ARRIVED = 1, REMOVED = 2 };

/// @brief An agent in the world.
struct Agent {
  AgentId id = 0;
  Pose pose;                           ///< in `map`
  Vector2 ahead = Vector2::UnitX();    ///< unit vector of the heading
  Vector2 velocity = Vector2::Zero();  ///< of the last tick, `map` [m/s]
  double max_speed = 0.0;              ///< maximum speed [m/s]
  double radius = 0.0;                 ///< [m]
  std::vector<Vector2> goals;          ///< [m], `map`
  std::size_t next_goal = 0;
  Vector2 present_goal = Vector2::Zero();  ///< present goal, or the last one after arrival [m], `map`
  Vector2 waypoint = Vector2::Zero();      ///< where it is to walk now, see setWaypoint() [m], `map`
  std::uint32_t goal_number = 0;           ///< number of changes of the goal or the waypoint
  AgentStatus status = AgentStatus::WALKING;
  bool leaves = true;               ///< see AgentStart
  bool has_waypoint = false;        ///< it perceives `waypoint` as its goal
  bool at_goal = false;             ///< reached its last goal, but does not leave
  bool held = false;                ///< stays where it is, see hold()
  bool yielding = false;            ///< stays where it is, see setYielding()
  std::uint64_t arrival_tick = 0;   ///< the tick at whose start it had arrived or was removed, unless it walks
  bool acted = false;               ///< an action was executed in the last tick
  bool blocked = false;             ///< its last move was cut short by an impact; solid worlds only
  std::uint64_t blocked_moves = 0;  ///< number of blocked moves
  bool in_contact = false;          ///< in the last tick
  bool bumped = false;              ///< took part in an impact since the end of the last tick
  bool touched = false;             ///< in contact in any tick so far
  bool in_collision = false;        ///< a rim or wall was within the collision radius at the end of the last tick
  bool collided = false;            ///< in collision in any tick so far
  /// False for a copy of an agent of another process (DistributedCrowd): others perceive it, but it does not perceive.
  bool perceives = true;

  bool isWalking() const { return status == AgentStatus::WALKING; }
  bool hasArrived() const { return status == AgentStatus::ARRIVED; }
  /// @brief The present goal, or the last one after arrival [m], `map`.
  const Vector2& goal() const { return present_goal; }
  /// @brief What the agent perceives as its goal: the waypoint if it has one, else goal() [m], `map`.
  const Vector2& perceivedGoal() const { return has_waypoint ? waypoint : present_goal; }
};

}  // namespace crowd
