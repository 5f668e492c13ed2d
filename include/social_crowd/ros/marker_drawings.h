#pragma once

#include <social_crowd/AgentStates.h>
#include <social_crowd/Scenario.h>
#include <visualization_msgs/Marker.h>

#include <vector>

#include "social_crowd/learning/states/obstacle_classes.h"
#include "social_crowd/ros/marker_paths.h"
#include "social_crowd/ros/marker_shapes.h"

/// What is drawn of a crowd: pure functions from messages to markers, one or two markers a kind however many agents
/// there are. Agents that are not on their way have no body, heading and radii; what is not finite is not drawn.
namespace crowd {

/// @brief Filled discs in the agents' colours.
visualization_msgs::Marker drawBodies(const social_crowd::AgentStates& states);
/// @brief Red rims of the bodies that are in contact now; in the bodies' namespace.
visualization_msgs::Marker drawContacts(const social_crowd::AgentStates& states);
/// @brief Arrows upon the bodies.
visualization_msgs::Marker drawHeadings(const social_crowd::AgentStates& states);
/// @brief Crosses in the agents' colours; also of agents that have arrived.
visualization_msgs::Marker drawGoals(const social_crowd::AgentStates& states);
visualization_msgs::Marker drawObstacles(const social_crowd::AgentStates& states);
visualization_msgs::Marker drawWalls(const std::vector<social_crowd::Wall>& walls);

/// @brief The part of the paths that does not change any more, drawn anew only now and then.
visualization_msgs::Marker drawSettledPaths(const WalkedPaths& paths);
/// @brief The rest of the paths, up to where the agents are now.
visualization_msgs::Marker drawRecentPaths(const WalkedPaths& paths);

/// @brief Whether the agent is or was last at a place that can be drawn.
bool hasPlace(const social_crowd::AgentState& agent);
/// @brief Whether the agent is on the floor and all its numbers can be drawn.
bool isOnFloor(const social_crowd::AgentState& agent);

/// @brief Circles around agents, one for each distance class.
class RadiiDrawing {
 public:
  /// @param agents so many will be added
  explicit RadiiDrawing(std::size_t agents);
  /// @param limits of the distance classes 1, 2, ... [m], from the agent's centre; the last is the radius of vision
  void add(const social_crowd::AgentState& agent, const std::vector<double>& limits, bool faint);
  visualization_msgs::Marker finish() { return marker_.finish(); }

 private:
  LineMarker marker_;
  std::vector<Vector2> circle_;
};

/// @brief What an agent finds occupied: of each sector the part that its distance class covers.
visualization_msgs::Marker drawSectors(const Pose& pose, const std::vector<OccupiedSector>& sectors,
                                       const std::vector<double>& limits);

}  // namespace crowd
