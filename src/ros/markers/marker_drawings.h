#pragma once

#include <social_crowd/AgentStates.h>
#include <social_crowd/RobotStates.h>
#include <social_crowd/Scenario.h>
#include <visualization_msgs/Marker.h>

#include <vector>

#include "learning/states/obstacle_classes.h"
#include "ros/markers/marker_paths.h"
#include "ros/markers/marker_shapes.h"
#include "ros/markers/marker_style.h"

/// Pure functions from messages to markers: one or two markers of each kind for any number of agents. Agents that do
/// not walk have no body, heading and radii. Values that are not finite are not drawn.
namespace crowd {

/// @brief Filled discs in the agents' colours. @param figures whether people stand on them: the discs are faint then
visualization_msgs::Marker drawBodies(const social_crowd::AgentStates& states, bool figures);
/// @brief Red rims of the bodies that are in contact; in the namespace of the bodies.
visualization_msgs::Marker drawContacts(const social_crowd::AgentStates& states);
/// @brief Arrows on the bodies. @param figures whether people stand on them, who have no arrows
visualization_msgs::Marker drawHeadings(const social_crowd::AgentStates& states, bool figures,
                                        const char* marker_namespace = marker_style::HEADINGS);
/// @brief The same as drawBodies() for recorded people.
visualization_msgs::Marker drawRecordedBodies(const social_crowd::AgentStates& people, bool figures);
/// @brief Crosses in the agents' colours; also of agents that have arrived.
visualization_msgs::Marker drawGoals(const social_crowd::AgentStates& states);
/// @brief The obstacles that are not recorded people.
visualization_msgs::Marker drawObstacles(const social_crowd::AgentStates& states);
visualization_msgs::Marker drawWalls(const std::vector<social_crowd::Wall>& walls);

/// @brief Filled footprints of the robots.
visualization_msgs::Marker drawRobots(const social_crowd::RobotStates& states);
/// @brief Arrows on the robots; in the namespace of the robots.
visualization_msgs::Marker drawRobotHeadings(const social_crowd::RobotStates& states);
/// @brief Red outlines of the robots in contact with people; in the namespace of the robots.
visualization_msgs::Marker drawRobotContacts(const social_crowd::RobotStates& states);
/// @brief Crosses; in the namespace of the agents' goals.
visualization_msgs::Marker drawRobotGoals(const social_crowd::RobotStates& states);

/// @brief Bodies that have walked paths.
enum class Walkers { AGENTS, ROBOTS };
/// @brief The settled parts of the paths, which are rarely drawn again.
visualization_msgs::Marker drawSettledPaths(const WalkedPaths& paths, Walkers walkers);
/// @brief The remaining parts of the paths, up to the present positions.
visualization_msgs::Marker drawRecentPaths(const WalkedPaths& paths, Walkers walkers);

/// @brief Whether the last position of the agent can be drawn.
bool hasPlace(const social_crowd::AgentState& agent);
/// @brief The same of a robot.
bool hasPlace(const social_crowd::RobotState& robot);
/// @brief Whether the agent walks and all its values can be drawn.
bool isOnFloor(const social_crowd::AgentState& agent);

/// @brief Circles around agents, one for each distance class.
class RadiiDrawing {
 public:
  /// @param agents number of agents that will be added
  explicit RadiiDrawing(std::size_t agents);
  /// @param limits of the distance classes 1, 2, ... [m], from the agent's centre; the last is the radius of vision
  void add(const social_crowd::AgentState& agent, const std::vector<double>& limits, bool faint);
  visualization_msgs::Marker finish() { return marker_.finish(); }

 private:
  LineMarker marker_;
  std::vector<Vector2> circle_;
};

/// @brief Occupied sectors of an agent: of each sector, the ring part of its distance class.
visualization_msgs::Marker drawSectors(const Pose& pose, const std::vector<OccupiedSector>& sectors,
                                       const std::vector<double>& limits);

}  // namespace crowd
