#pragma once

#include "world/world.h"

namespace crowd {

/// @brief What is told about agents that appear, and about their routes. Population calls it between two ticks.
class RouteObserver {
 public:
  RouteObserver() = default;
  RouteObserver(const RouteObserver&) = default;
  RouteObserver& operator=(const RouteObserver&) = default;
  RouteObserver(RouteObserver&&) = default;
  RouteObserver& operator=(RouteObserver&&) = default;
  virtual ~RouteObserver() = default;

  /// @brief Registers the agent that was added to the world last.
  virtual void watch(const AgentStart& start, const World& world) = 0;
  /// @brief Records a new goal of an agent [m]; its straight length is then that from its start via its present
  /// position to that goal.
  virtual void recordGoal(const Agent& agent, const Vector2& goal) = 0;
  /// @brief Adds the way from an agent's position to its goal, that of the next leg of its route, to its straight
  /// length.
  virtual void extendWay(const Agent& agent) = 0;
  /// @brief Adds what a further place [m] on the way of an agent to its goal lengthens this way by.
  virtual void addDetour(const Agent& agent, const Vector2& place) = 0;
  /// @brief Counts a waypoint that an agent leaves behind.
  virtual void countWaypoint(AgentId id) = 0;
  /// @brief Whether the agent is on a route that repeats.
  virtual void setEndless(AgentId id, bool endless) = 0;
};

}  // namespace crowd
