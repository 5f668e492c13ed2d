#pragma once

#include <cstdint>
#include <vector>

#include "geometry/geometry.h"
#include "scenario/scene.h"
#include "world/perception.h"

namespace crowd {

/// @brief Bodies that overlap by more than this are in contact [m].
constexpr double CONTACT_OVERLAP = 1e-3;

/// @brief WALKING: on its way. ARRIVED, REMOVED: not in the world any more.
enum class AgentStatus : std::uint8_t { WALKING = 0, ARRIVED = 1, REMOVED = 2 };

/// @brief An agent in the world.
struct Agent {
  Agent() = default;
  Agent(AgentId number, const AgentStart& start)
      : id(number),
        pose{start.position, wrapAngle(start.heading)},
        ahead(unitVector(pose.heading)),
        max_speed(start.max_speed),
        radius(start.radius),
        goals(start.goals),
        present_goal(start.goals.front()),
        leaves(start.leaves) {}

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
  bool held = false;                ///< stays where it is, whatever its actions
  bool yielding = false;            ///< the same, for agents that give way to others; both are independent
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

  /// @brief Replaces all goals by one [m], `map`.
  void setGoal(const Vector2& goal) {
    goals = {goal};
    next_goal = 0;
    present_goal = goal;
    has_waypoint = false;
    at_goal = false;
    ++goal_number;
  }
  /// @brief Sets the point that the agent perceives in place of its goal, which remains the point where it arrives,
  /// until it reaches the goal or gets another one [m], `map`.
  void setWaypoint(const Vector2& place) {
    if (has_waypoint && waypoint == place) return;
    waypoint = place;
    has_waypoint = true;
    ++goal_number;
  }
  /// @brief Makes the agent perceive its goal again.
  void clearWaypoint() {
    goal_number += has_waypoint ? 1 : 0;
    has_waypoint = false;
  }
  /// @brief Puts the agent at another place at once, where it stands. @param place in `map`
  void teleport(const Pose& place) {
    pose = {place.position, wrapAngle(place.heading)};
    ahead = unitVector(pose.heading);
    velocity = Vector2::Zero();
    has_waypoint = false;
    at_goal = false;
    ++goal_number;
  }
};

}  // namespace crowd
