#pragma once

#include <ros/console.h>
#include <ros/init.h>

#include <iostream>
#include <string>

namespace crowd {

/// @brief Logs information. ROS_INFO prints nothing while ROS shuts down; then the text is written directly to the
/// standard output in the same format.
inline void logInfo(const std::string& text) {
  if (ros::isShuttingDown()) {
    std::cout << "[ INFO] [" << ros::WallTime::now() << "]: " << text << std::endl;
  } else {
    ROS_INFO("%s", text.c_str());
  }
}

/// @brief Logs an error that ends the node, to the standard error while ROS shuts down.
inline void logFatal(const std::string& text) {
  if (ros::isShuttingDown()) {
    std::cerr << "[FATAL] [" << ros::WallTime::now() << "]: " << text << std::endl;
  } else {
    ROS_FATAL("%s", text.c_str());
  }
}

}  // namespace crowd
