#pragma once

#include <ros/ros.h>

#include <exception>
#include <iostream>

#include "social_crowd/ros/console.h"

namespace crowd {

/// @brief main() of a node: creates a `Node` with the two node handles and runs it. Errors are logged.
/// @return exit status: 0, or 1 after an error
template <typename Node>
int runNode(int argc, char** argv, const char* name) {
  try {
    ros::init(argc, argv, name);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
    return 1;
  }
  const ros::NodeHandle keeps_the_console;  // ROS shuts down with its last handle; nothing is logged after that
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
