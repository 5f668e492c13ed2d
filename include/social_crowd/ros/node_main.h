#pragma once

#include <ros/ros.h>

#include <exception>
#include <iostream>

#include "social_crowd/ros/console.h"

namespace crowd {

/// @brief main() of a node: makes a `Node` from the two node handles and runs it until it ends or ROS shuts down. What
/// goes wrong is told in words.
/// @return exit status: 0, or 1 after an error.
template <typename Node>
int runNode(int argc, char** argv, const char* name) {
  try {
    ros::init(argc, argv, name);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
    return 1;
  }
  const ros::NodeHandle keeps_the_console;  // ROS shuts down with its last handle and is mute from then on
  try {
    Node node((ros::NodeHandle()), ros::NodeHandle("~"));
    node.run();
    return 0;
  } catch (const std::exception& error) {
    logFatal(error.what());
    return 1;
  }
}

}  // namespace crowd
