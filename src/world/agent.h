#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/geometry.h"
#include "scenario/scene.h"
#include "world/perception.h"

namespace crowd {

/// @brief Bodies that overlap by more than this are in contact [m].
constexpr double CONTACT_OVERLAP = 1e-3;

/// @brief WALKING: on its way. ARRIVED, REMOVED: not in the world any more. STAYING: has arrived, and stays in the
/// world as a body at rest (Arrived::STAY).
enum class AgentStatus : std::uint8_t { WALKING = 0, ARRIVED = 1, REMOVED = 2, STAYING = 3 };

/// @brief Why an agent stands, or brakes, whatever its actions.
enum class Hold : std::uint8_t { ROUTE, PAUSE, ATTRACTION, REACTION };

/// @brief Why an agent walks faster or slower than its own speed.
enum class Pace : std::uint8_t { HURRY, DISTRACTION, GROUP, REACTION };
constexpr std::size_t PACES = 4;

/// @brief An agent in the world.
struct Agent {
  Agent() = default;
  Agent(AgentId number, const AgentStart& start)
      : id(number),
        pose{start.position, wrapAngle(start.heading)},
        ahead(unitVector(pose.heading)),
        velocity(start.velocity),
        max_speed(start.walkingSpeed()),
        own_speed(start.max_speed),
        wanted_speed(start.walkingSpeed()),
        paces{start.hurry, 1.0, 1.0, 1.0},
        radius(start.radius),
        kind(start.kind),
        figure(start.figure),
        goals(start.goals),
        present_goal(start.goals.front()),
        group(start.group),
        leaves(start.leaves),
        stays(start.stays) {}

  AgentId id = 0;
  Pose pose;                           ///< in `map`
  Vector2 ahead = Vector2::UnitX();    ///< unit vector of the heading
  Vector2 velocity = Vector2::Zero();  ///< of the last tick, `map` [m/s]
  double max_speed = 0.0;              ///< present maximum speed [m/s]
  double own_speed = 0.0;              ///< maximum speed without any Pace [m/s]
  double wanted_speed = 0.0;           ///< own_speed times all paces; `max_speed` as soon as it has slowed down [m/s]
  std::array<double, PACES> paces = {1.0, 1.0, 1.0, 1.0};
  double radius = 0.0;          ///< [m]
  std::int32_t kind = NO_KIND;  ///< see AgentStart
  Figure figure = Figure::ADULT;
  std::vector<Vector2> goals;  ///< [m], `map`
  std::size_t next_goal = 0;
  Vector2 present_goal = Vector2::Zero();  ///< present goal, or the last one after arrival [m], `map`
  Vector2 waypoint = Vector2::Zero();      ///< where it is to walk now, see setWaypoint() [m], `map`
  std::uint32_t goal_number = 0;           ///< number of changes of the goal or the waypoint
  AgentStatus status = AgentStatus::WALKING;
  GroupId group = NO_GROUP;         ///< see AgentStart
  bool leaves = true;               ///< see AgentStart
  bool stays = false;               ///< see AgentStart
  bool has_waypoint = false;        ///< it perceives `waypoint` as its goal
  bool at_goal = false;             ///< reached its last goal, but does not leave
  std::uint8_t holds = 0;           ///< one bit for each Hold
  bool yielding = false;            ///< stands as well, because it gives way to others
  std::uint64_t arrival_tick = 0;   ///< the tick at whose start it had arrived or was removed, unless it walks
  bool acted = false;               ///< an action was executed in the last tick
  bool blocked = false;             ///< its last move was cut short by an impact; solid worlds only
  std::uint64_t blocked_moves = 0;  ///< number of blocked moves
  bool in_contact = false;          ///< in the last tick
  bool bumped = false;              ///< took part in an impact since the end of the last tick
  bool touched = false;             ///< in contact in any tick so far, until it arrived
  bool in_collision = false;        ///< a rim or wall was within the collision radius at the end of the last tick
  bool collided = false;            ///< in collision in any tick so far, until it arrived
  /// False for a copy of an agent of another process (DistributedCrowd): others perceive it, but it does not perceive.
  bool perceives = true;

  bool isWalking() const { return status == AgentStatus::WALKING; }
  bool hasArrived() const { return status == AgentStatus::ARRIVED || status == AgentStatus::STAYING; }
  /// @brief Whether it is a body of the world: on its way, or arrived and staying.
  bool isPresent() const { return isWalking() || status == AgentStatus::STAYING; }
  /// @brief Ends its way. One that stays stands from now on. @param why ARRIVED, REMOVED or STAYING
  void end(AgentStatus why, std::uint64_t tick) {
    status = why;
    arrival_tick = tick;
    if (why != AgentStatus::STAYING) return;
    velocity = Vector2::Zero();
    holds = 0;
  }
  /// @brief What it becomes at its last goal.
  AgentStatus statusAtEnd() const { return stays ? AgentStatus::STAYING : AgentStatus::ARRIVED; }
  bool isHeldBy(Hold reason) const { return (holds & bitOf(reason)) != 0; }
  bool isHeld() const { return holds != 0; }
  void setHeld(Hold reason, bool is_held) {
    holds = static_cast<std::uint8_t>(is_held ? holds | bitOf(reason) : holds & ~bitOf(reason));
  }
  double paceOf(Pace reason) const { return paces[static_cast<std::size_t>(reason)]; }
  /// @brief Sets a factor of its speed. World lets `max_speed` follow at the end of the tick.
  void setPace(Pace reason, double factor) {
    paces[static_cast<std::size_t>(reason)] = factor;
    wanted_speed = own_speed;
    for (const double pace : paces) wanted_speed *= pace;
  }
  /// @brief Changes the direction in which it looks [rad].
  void setHeading(double heading) {
    pose.heading = wrapAngle(heading);
    ahead = unitVector(pose.heading);
  }
  /// @brief The present goal, or the last one after arrival [m], `map`.
  const Vector2& goal() const { return present_goal; }
  /// @brief What the agent perceives as its goal: the waypoint if it has one, else goal() [m], `map`.
  const Vector2& perceivedGoal() const { return has_waypoint ? waypoint : present_goal; }

  /// @brief Replaces all goals by one [m], `map`.
  void setGoal(const Vector2& goal) { setGoals({goal}); }
  /// @brief Replaces all goals by others, at least one [m], `map`.
  void setGoals(std::vector<Vector2> others) {
    goals = std::move(others);
    next_goal = 0;
    present_goal = goals.front();
    has_waypoint = false;
    at_goal = false;
    ++goal_number;
  }
  /// @brief Adds a goal before the present one [m], `map`.
  void insertGoal(const Vector2& goal) {
    goals.insert(goals.begin() + static_cast<std::ptrdiff_t>(next_goal), goal);
    beginGoal();
  }
  /// @brief Replaces the present goal [m], `map`; those after it stay.
  void replaceGoal(const Vector2& goal) {
    goals[next_goal] = goal;
    beginGoal();
  }
  /// @brief Goes on to the goal after the present one. There must be one.
  void passGoal() {
    ++next_goal;
    beginGoal();
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
    pose.position = place.position;
    setHeading(place.heading);
    velocity = Vector2::Zero();
    has_waypoint = false;
    at_goal = false;
    ++goal_number;
  }

 private:
  void beginGoal() {
    present_goal = goals[next_goal];
    has_waypoint = false;
    ++goal_number;
  }
  static unsigned bitOf(Hold reason) { return 1U << static_cast<unsigned>(reason); }
};

}  // namespace crowd
