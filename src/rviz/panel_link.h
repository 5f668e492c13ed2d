#pragma once

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "ros/node/master_watch.h"
#include "ros/node/service_line.h"
#include "rviz/node_watch.h"
#include "rviz/panel_model.h"

namespace crowd {

/// @brief Connects a PanelModel with ROS: topics, calls of services, and a look whether nodes are there. All of it runs
/// in threads of its own; the owner of the model calls exchange() periodically, which never waits.
class PanelLink {
 public:
  /// @param node whose namespace is that of the topics @param controller, markers full names of the nodes
  PanelLink(ros::NodeHandle node, const std::string& controller, const std::string& markers);
  ~PanelLink();

  /// @brief Passes on to the model what has been received, and begins the calls that it wants. Runs in the thread that
  /// owns the model.
  void exchange(PanelModel& model);

 private:
  using Event = std::function<void(PanelModel&)>;

  /// Keeps an event for the next exchange(). Thread-safe.
  void note(Event event);
  /// The name of the service by which a node is recognised.
  std::string signOf(const std::string& node) const;

  std::shared_ptr<MasterWatch> master_watch_ = MasterWatch::ofProcess();
  std::string controller_;
  std::string markers_;
  std::mutex mutex_;
  std::vector<Event> events_;
  ros::CallbackQueue queue_;
  std::vector<ros::Subscriber> subscribers_;
  std::map<std::pair<std::string, bool>, ServiceLine> lines_;  // by node, and whether for steps
  NodeWatch watch_;
  ros::AsyncSpinner spinner_;
};

}  // namespace crowd
