#pragma once

#include <ros/ros.h>

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "ros/node/console.h"
#include "ros/node/master_watch.h"

namespace crowd {

/// @brief Runs a node in a thread of its own, so that one process can contain several nodes.
template <typename Node>
class NodeThread {
 public:
  /// @param name for log messages
  /// @param at_end is called in that thread when the node ends by itself
  /// @throws the exceptions of the constructor of the node
  NodeThread(const ros::NodeHandle& node, const ros::NodeHandle& private_node, const std::string& name,
             std::function<void()> at_end)
      : node_(node, private_node), thread_([this, name, at_end = std::move(at_end)] { run(name, at_end); }) {}
  /// @brief Stops the node and waits for its end.
  ~NodeThread() {
    stopped_ = true;
    node_.stop();
    thread_.join();
  }
  NodeThread(const NodeThread&) = delete;
  NodeThread& operator=(const NodeThread&) = delete;

 private:
  void run(const std::string& name, const std::function<void()>& at_end) {
    try {
      node_.run();
    } catch (const std::exception& error) {
      logFatal(name + ": " + error.what());
    }
    if (!stopped_ && ros::ok()) at_end();
  }

  std::shared_ptr<MasterWatch> master_watch_ = MasterWatch::ofProcess();
  Node node_;
  std::atomic<bool> stopped_{false};
  std::thread thread_;  // last member: it uses all others
};

}  // namespace crowd
