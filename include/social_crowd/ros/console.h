#pragma once

#include <ros/console.h>
#include <ros/init.h>

#include <iostream>
#include <string>

namespace crowd {

/// @brief Prints information of a node that may be about to end. ROS_INFO prints nothing once ROS shuts down, which
/// Ctrl-C starts; then the text goes straight to the standard output, in the form of the console.
inline void logInfo(const std::string& text) {
  if (ros::isShuttingDown()) {
    std::cout << "[ INFO] [" << ros::WallTime::now() << "]: " << text << std::endl;
  } else {
    ROS_INFO("%s", text.c_str());
  }
}

/// @brief The same of an error that ends the node; to the standard error.
inline void logFatal(const std::string& text) {
  if (ros::isShuttingDown()) {
    std::cerr << "[FATAL] [" << ros::WallTime::now() << "]: " << text << std::endl;
  } else {
    ROS_FATAL("%s", text.c_str());
  }
}

}  // namespace crowd
