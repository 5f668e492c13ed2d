#pragma once

#include <ros/ros.h>
#include <rviz/visualization_manager.h>
#include <social_crowd/Scenario.h>

#include <string>

namespace crowd {

/// @brief Fits the present view of RViz to the floor when the scenario changes. The first scenario that it receives
/// leaves the view as it is, which show_crowd, or the user, has set.
///
/// It knows rviz/TopDownOrtho, and views about a focal point (Orbit, XYOrbit, ThirdPersonFollower), whose target frame
/// is `crowd` or `map`; others stay as they are.
///
/// Used by CrowdPanel; everything runs in the thread of RViz.
class ViewFollower {
 public:
  /// @param node whose namespace is that of the topics
  ViewFollower(ros::NodeHandle node, rviz::VisualizationManager& manager);

 private:
  void take(const social_crowd::Scenario& scenario);

  rviz::VisualizationManager& manager_;
  std::string scenario_;  // name; empty: none was received
  ros::Subscriber subscriber_;
};

}  // namespace crowd
