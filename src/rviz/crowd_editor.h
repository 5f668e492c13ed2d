#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <interactive_markers/interactive_marker_server.h>
#include <ros/ros.h>
#include <social_crowd/AgentStates.h>
#include <social_crowd/RobotStates.h>
#include <social_crowd/Scenario.h>
#include <std_msgs/Int32.h>

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "ros/node/main_loop.h"
#include "ros/node/service_line.h"
#include "rviz/editor_handles.h"

namespace crowd {

/// @brief Parameters of the node crowd_editor with their defaults.
struct EditorParameters {
  std::string controller = "crowd_controller";  ///< ~controller: name of the crowd controller
  std::string markers = "crowd_markers";        ///< ~markers: name of the node that shows an agent
  double rate = 10.0;                           ///< ~rate: of the handles [Hz], wall clock
  std::size_t most_handles = 60;  ///< ~max_handles: agents, obstacles, and robots, that have handles at most
};

/// @throws InputError that lists all invalid parameters
EditorParameters readEditorParameters(const ros::NodeHandle& private_node);

/// @brief Node with which a user moves agents, goals, obstacles and robots in RViz: it publishes an interactive marker
/// for each, and calls services of the crowd controller when one is dropped. It also passes goals on
/// `chosen_agent/goal` (2D Nav Goal in RViz) to the chosen agent.
class CrowdEditor {
 public:
  /// @throws InputError that lists invalid parameters
  CrowdEditor(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// @brief Serves until stop() is called or ROS shuts down.
  void run();
  /// @brief Makes run() return soon. Thread-safe.
  void stop() { loop_.close(); }

 private:
  using Feedback = visualization_msgs::InteractiveMarkerFeedback;

  /// Takes the start of an episode, as a paused controller does not repeat the present state.
  void takeScenario(const social_crowd::Scenario& scenario);
  void takeStates(const social_crowd::AgentStates::ConstPtr& states);
  void update();
  /// Takes the feedback that has come since the last call.
  void takeFeedback();
  void take(const Feedback& feedback);
  void takeGoal(const geometry_msgs::PoseStamped& goal);
  void drop(const std::string& name, const Vector2& place);
  void choose(const std::string& name, EditorEntry entry);
  void show(const EditorHandles& handles);
  /// Whether a handle is in the hand of a user, or its service has not answered yet.
  bool isHeld(const std::string& name) const { return held_.count(name) > 0; }
  /// Calls a service. The handle follows the crowd again afterwards.
  template <typename Service>
  void call(const std::string& node, const char* service, const typename Service::Request& request,
            const std::string& handle);

  const EditorParameters parameters_;
  MainLoop loop_;
  ros::NodeHandle node_;
  social_crowd::AgentStates::ConstPtr states_;
  social_crowd::RobotStates::ConstPtr robots_;
  std::int64_t chosen_agent_ = -1;
  std::uint64_t removals_ = 0;  // number of times that obstacles were removed
  EditorHandles shown_;
  std::map<std::string, ros::WallTime> held_;  // by handle; with the time of the last feedback
  std::mutex mutex_;
  std::vector<Feedback> feedback_;     // not yet taken
  std::vector<std::string> answered_;  // handles whose services have answered
  interactive_markers::InteractiveMarkerServer server_;
  std::vector<ros::Subscriber> subscribers_;
  ros::WallTimer timer_;
  ServiceLine line_;  // last member: its thread uses the others
};

}  // namespace crowd
