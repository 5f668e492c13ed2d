#pragma once

#include <social_crowd/AgentStates.h>
#include <social_crowd/RobotStates.h>
#include <visualization_msgs/InteractiveMarker.h>

#include <cstdint>
#include <map>
#include <string>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Something on the floor that a user can drag in RViz.
struct EditorHandle {
  enum class Kind { AGENT, GOAL, OBSTACLE, ROBOT };
  Kind kind = Kind::AGENT;
  std::uint32_t number = 0;         ///< of the agent, obstacle or robot
  Vector2 place = Vector2::Zero();  ///< [m], `map`
  double heading = 0.0;             ///< of an agent or robot [rad], `map`
  double radius = 0.0;              ///< [m]
  std::string name = {};            ///< of a robot
};

/// @brief Handles by the names of their markers, such as agent_3, goal_3, obstacle_0 and robot_tug.
using EditorHandles = std::map<std::string, EditorHandle>;

/// @brief Number of obstacles that can be moved and removed: all but recorded people.
std::size_t countMovable(const social_crowd::AgentStates& states);

/// @brief The handles of agents on their way with their goals, of obstacles that can be moved, and of robots. Of a kind
/// with more than `most`, no handles are made, except those of the chosen agent.
/// @param removals how often obstacles were removed, which renumbers others: the names of their handles change, so that
/// what a user still does with an old one has no effect on another obstacle
EditorHandles handlesOf(const social_crowd::AgentStates& states, const social_crowd::RobotStates& robots,
                        std::size_t most, std::int64_t chosen_agent, std::uint64_t removals);

/// @brief The marker of a handle: a translucent cylinder that moves on the floor, with a menu.
visualization_msgs::InteractiveMarker markerOf(const std::string& name, const EditorHandle& handle);

/// @brief The pose of such a marker.
geometry_msgs::Pose poseOf(const EditorHandle& handle);

/// @brief Entries of the menu of a handle. SHOW chooses the agent; obstacles and robots have REMOVE alone.
enum class EditorEntry : std::uint32_t { REMOVE = 1, SHOW = 2 };

}  // namespace crowd
