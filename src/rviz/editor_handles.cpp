#include "rviz/editor_handles.h"

#include <algorithm>
#include <cmath>

#include "ros/messages/conversions.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

using Kind = EditorHandle::Kind;
using social_crowd::AgentState;
using visualization_msgs::InteractiveMarker;
using visualization_msgs::InteractiveMarkerControl;
using visualization_msgs::Marker;
using visualization_msgs::MenuEntry;

constexpr double GOAL_RADIUS = 0.25;  // [m]
constexpr double RIM = 0.05;          // of the disc around a body [m]
constexpr double TALL = 2.0;          // encloses the markers of a body, which cannot be dragged [m]
constexpr double FLAT = 0.3;          // the same, of a goal [m]

std_msgs::ColorRGBA colourOf(Kind kind) {
  std_msgs::ColorRGBA colour;
  colour.r = kind == Kind::GOAL ? 0.1F : 0.2F;
  colour.g = kind == Kind::GOAL ? 0.6F : 0.4F;
  colour.b = kind == Kind::GOAL ? 0.3F : 0.9F;
  colour.a = 0.15F;
  return colour;
}

InteractiveMarkerControl controlOf(const EditorHandle& handle) {
  InteractiveMarkerControl control;
  control.name = "move";
  control.always_visible = 1;
  control.interaction_mode = InteractiveMarkerControl::MOVE_PLANE;
  control.orientation_mode = InteractiveMarkerControl::FIXED;
  control.orientation.w = control.orientation.y = std::sqrt(0.5);  // the x axis, normal to the plane, points up
  Marker disc;                                                     // a cylinder, seen from above
  disc.type = Marker::CYLINDER;
  disc.pose.orientation.w = 1.0;
  disc.scale.z = handle.kind == Kind::GOAL ? FLAT : TALL;
  disc.pose.position.z = 0.5 * disc.scale.z;
  disc.scale.x = disc.scale.y = 2.0 * (handle.radius + RIM);
  disc.color = colourOf(handle.kind);
  control.markers.push_back(disc);
  return control;
}

MenuEntry entryOf(EditorEntry entry, const std::string& title) {
  MenuEntry menu;
  menu.id = static_cast<std::uint32_t>(entry);
  menu.title = title;
  menu.command_type = MenuEntry::FEEDBACK;
  return menu;
}

}  // namespace

std::size_t countMovable(const social_crowd::AgentStates& states) {
  const auto is_movable = [](const social_crowd::ObstacleState& obstacle) { return obstacle.recorded == 0; };
  return static_cast<std::size_t>(std::count_if(states.obstacles.begin(), states.obstacles.end(), is_movable));
}

EditorHandles handlesOf(const social_crowd::AgentStates& states, const social_crowd::RobotStates& robots,
                        std::size_t most, std::int64_t chosen_agent, std::uint64_t removals) {
  EditorHandles handles;
  for (const social_crowd::RobotState& robot : robots.robots) {
    if (robots.robots.size() > most) break;
    handles["robot_" + robot.name] = {Kind::ROBOT,      robot.robot,  {robot.pose.x, robot.pose.y},
                                      robot.pose.theta, robot.radius, robot.name};
  }
  const auto walking =
      static_cast<std::size_t>(std::count_if(states.agents.begin(), states.agents.end(), [](const AgentState& agent) {
        return agent.status == AgentState::WALKING;
      }));
  for (const AgentState& agent : states.agents) {
    if (agent.status != AgentState::WALKING || (walking > most && agent.agent != chosen_agent)) continue;
    const std::string number = std::to_string(agent.agent);
    handles["agent_" + number] = {
        Kind::AGENT, agent.agent, {agent.pose.x, agent.pose.y}, agent.pose.theta, agent.radius};
    handles["goal_" + number] = {Kind::GOAL, agent.agent, fromPoint(agent.goal), 0.0, GOAL_RADIUS};
  }
  if (countMovable(states) > most) return handles;
  const std::string generation = removals == 0 ? "" : "_after_" + std::to_string(removals);
  for (const social_crowd::ObstacleState& obstacle : states.obstacles) {
    if (obstacle.recorded != 0) continue;
    handles["obstacle_" + std::to_string(obstacle.obstacle) + generation] = {
        Kind::OBSTACLE, obstacle.obstacle, fromPoint(obstacle.position), 0.0, obstacle.radius};
  }
  return handles;
}

geometry_msgs::Pose poseOf(const EditorHandle& handle) {
  geometry_msgs::Pose pose;
  pose.position = toPoint(handle.place);
  pose.orientation.w = 1.0;
  return pose;
}

InteractiveMarker markerOf(const std::string& name, const EditorHandle& handle) {
  InteractiveMarker marker;
  marker.header.frame_id = names::MAP_FRAME;
  marker.name = name;
  marker.pose = poseOf(handle);
  marker.scale = static_cast<float>(2.0 * handle.radius);
  marker.controls.push_back(controlOf(handle));
  const std::string title = handle.kind == Kind::ROBOT ? "robot " + handle.name : name;
  if (handle.kind != Kind::GOAL) marker.menu_entries.push_back(entryOf(EditorEntry::REMOVE, "Remove " + title));
  if (handle.kind == Kind::AGENT || handle.kind == Kind::GOAL) {
    marker.menu_entries.push_back(entryOf(EditorEntry::SHOW, "Show agent " + std::to_string(handle.number)));
  }
  return marker;
}

}  // namespace crowd
