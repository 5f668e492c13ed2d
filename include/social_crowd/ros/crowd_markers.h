#pragma once

#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include "social_crowd/ros/main_loop.h"
#include "social_crowd/ros/marker_scene.h"

namespace crowd {

/// @brief Parameters of the node crowd_markers. The other defaults stand in MarkerOptions.
struct MarkerParameters {
  MarkerOptions options;  ///< ~agent (-1: none), ~radii (none, chosen or all), ~path_step [m], ~path_points
  double rate = 20.0;     ///< ~rate: markers are published at most so often [Hz], wall clock
};

/// @throws InputError naming everything that is wrong.
MarkerParameters readMarkerParameters(const ros::NodeHandle& private_node);

/// @brief The node that shows a crowd in RViz. It knows the crowd from topics alone, so that a recording can be shown
/// as well.
///
/// It also publishes the frame `crowd`, in the middle of the scenario (at whole metres), to which RViz's view and grid
/// are bound.
///
/// Draws at a limited rate, and only if somebody listens and something has changed. Once a second everything is
/// repeated, changed or not: RViz forgets the markers of a namespace that is switched off and needs them when it is
/// switched on.
class CrowdMarkers {
 public:
  /// @throws InputError naming bad parameters.
  CrowdMarkers(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// @brief Draws until it is stopped or ROS shuts down.
  void run();
  /// @brief From another thread: lets run() return soon.
  void stop() { loop_.close(); }

 private:
  CrowdMarkers(const ros::NodeHandle& node, const MarkerParameters& parameters);
  /// Subscribes to a topic whose messages the scene takes.
  template <typename Message>
  ros::Subscriber subscribe(const char* topic);
  void takeScenario(const social_crowd::Scenario& message);
  /// Tells tf where the middle of the crowd is. RViz wants to know a transform of its fixed frame, too.
  void publishFrame(const Vector2& middle);
  void subscribeToPerceptions(bool wanted);
  void publish();

  MainLoop loop_;
  ros::NodeHandle node_;
  bool shows_sectors_;
  MarkerScene scene_;
  ros::Publisher publisher_;
  tf2_ros::StaticTransformBroadcaster frame_broadcaster_;
  std::string scenario_name_;  // of the scenario in whose middle the frame is
  ros::Subscriber agents_;
  ros::Subscriber scenario_;
  ros::Subscriber learner_status_;
  ros::Subscriber perceptions_;  // only while somebody looks at what comes of them: they are the largest messages
  ros::WallTimer timer_;
  ros::WallTime last_whole_;  // when everything was drawn
  std::uint32_t listeners_ = 0;
};

}  // namespace crowd
