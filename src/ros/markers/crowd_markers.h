#pragma once

#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "ros/markers/marker_scene.h"
#include "ros/node/main_loop.h"
#include "ros/node/services.h"

namespace crowd {

/// @brief Parameters of the node crowd_markers; see MarkerOptions for the other defaults.
struct MarkerParameters {
  MarkerOptions options;  ///< ~agent (-1: none), ~radii (none, chosen or all), ~figures (auto, discs or people),
                          ///< ~path_time [s], ~path_step [m], ~path_points
  bool values = true;     ///< ~values: whether the values of the chosen agent's moves are shown
  double rate = 20.0;     ///< ~rate: maximum rate of markers [Hz], wall clock
};

/// @throws InputError that lists all invalid parameters
MarkerParameters readMarkerParameters(const ros::NodeHandle& private_node);

/// @brief Node that shows a crowd in RViz. It uses topics only, so that it can also show a recording.
///
/// It also publishes the frame `crowd` at the centre of the scenario (rounded to metres), which RViz uses for view and
/// grid.
///
/// It draws at a limited rate, and only if there are subscribers and the scene has changed. All markers are repeated
/// once per second, because RViz discards the markers of a namespace that is switched off.
class CrowdMarkers {
 public:
  /// @throws InputError that lists invalid parameters
  CrowdMarkers(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// @brief Draws until stop() is called or ROS shuts down.
  void run();
  /// @brief Makes run() return soon. Thread-safe.
  void stop() { loop_.close(); }

 private:
  CrowdMarkers(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const MarkerParameters& parameters);
  /// Subscribes to a topic and passes its messages to the scene.
  template <typename Message>
  ros::Subscriber subscribe(const char* topic);
  void takeScenario(const social_crowd::Scenario& message);
  /// Publishes the frame `crowd`. RViz also needs a transform of its fixed frame.
  void publishFrame(const Vector2& middle);
  /// Subscribes to what is shown of the chosen agent alone.
  void subscribeToPerceptions(bool wanted);
  void subscribeToValues(bool wanted);
  void publish();
  /// Chooses the agent whose sectors and values are shown, and tells it on `chosen_agent`.
  void choose(std::int64_t agent);

  MainLoop loop_;
  ros::NodeHandle node_;
  bool has_chosen_ = false;  // an agent whose sectors and values are shown
  bool shows_values_;
  MarkerScene scene_;
  ros::Publisher publisher_;
  ros::Publisher chosen_;
  tf2_ros::StaticTransformBroadcaster frame_broadcaster_;
  std::string scenario_name_;  // scenario of the present frame
  ros::Subscriber agents_;
  ros::Subscriber scenario_;
  ros::Subscriber walls_;
  ros::Subscriber map_;
  ros::Subscriber robots_;
  ros::Subscriber learner_status_;
  ros::Subscriber perceptions_;  // only while there are subscribers, because these messages are large
  ros::Subscriber values_;       // the same, because then learners publish them
  ros::WallTimer timer_;
  ros::WallTime last_whole_;  // time of the last complete drawing
  std::uint32_t listeners_ = 0;
  Services services_;  // last member: its thread uses all others
};

}  // namespace crowd
