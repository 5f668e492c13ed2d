#pragma once

#include <ros/ros.h>
#include <social_crowd/ControllerStatus.h>

#include <functional>

#include "world/world.h"

namespace crowd {

/// @brief Writes tick, time and counts of agents.
void toMessage(const World& world, social_crowd::ControllerStatus& message);

/// @brief Publishes the status of the crowd controller for user interfaces: when it has changed, at most ten times per
/// second, and to each new subscriber. Costs nothing without subscribers. Owned by CrowdController; all functions run
/// in its main loop.
class ControllerStatusPublisher {
 public:
  /// @param node whose callbacks the main loop serves @param status returns the present status
  ControllerStatusPublisher(ros::NodeHandle node, std::function<social_crowd::ControllerStatus()> status);

  /// @brief Publishes if there are subscribers and the status has changed.
  void publish();

 private:
  std::function<social_crowd::ControllerStatus()> status_;
  social_crowd::ControllerStatus last_;
  ros::Publisher publisher_;
  ros::WallTimer timer_;
};

}  // namespace crowd
