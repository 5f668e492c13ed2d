#pragma once

#include <ros/ros.h>

#include <exception>
#include <iostream>
#include <memory>

#include "common/stop_request.h"
#include "ros/node/console.h"
#include "ros/node/master_watch.h"

namespace crowd {

/// @brief What --help prints of a node.
struct NodeUsage {
  const char* what;     ///< what the node does, a sentence
  const char* example;  ///< arguments of an example
};

/// @brief Prints the usage of a node if it is asked for. @return whether it was
bool printUsage(int argc, char** argv, const char* name, const NodeUsage& usage);

/// @brief main() of a node: creates a `Node` with the two node handles and runs it; with --help, prints the usage.
/// Errors are logged.
/// @return exit status: 0, or 1 after an error
template <typename Node>
int runNode(int argc, char** argv, const char* name, const NodeUsage& usage) {
  if (printUsage(argc, argv, name, usage)) return 0;
  try {
    ros::init(argc, argv, name);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << std::endl;
    return 1;
  }
  const ros::NodeHandle keeps_the_console;  // ROS shuts down with its last handle; nothing is logged after that
  // rosout reads this at the first message, for which the master registers the node. If that message is about the end
  // of this node because another one has taken its name, the master would end that one, too. So it is read now.
  bool is_unused = false;
  ros::param::getCached("/rosout_disable_topics_generation", is_unused);
  const std::shared_ptr<MasterWatch> master_watch = MasterWatch::ofProcess();
  try {
    Node node((ros::NodeHandle()), ros::NodeHandle("~"));
    node.run();
    return 0;
  } catch (const Stopped&) {  // by Ctrl-C, before it ran
    return 0;
  } catch (const std::exception& error) {
    logFatal(error.what());
    return 1;
  }
}

}  // namespace crowd
