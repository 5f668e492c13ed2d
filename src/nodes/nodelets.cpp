// The nodes as nodelets: in one process they exchange messages by pointer.

#include <nodelet/NodeletUnload.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
#include <string>
#include <thread>

#include "ros/controller/crowd_controller.h"
#include "ros/learner/learner_node.h"
#include "ros/markers/crowd_markers.h"
#include "ros/node/node_thread.h"

namespace crowd {
namespace {

/// Requests that the manager unloads a nodelet that is done; the program that loaded it then ends, too. Without a
/// manager (standalone nodelet), the process is shut down.
void unload(const std::string& name) {
  nodelet::NodeletUnload call;
  call.request.name = name;
  const bool has_manager = ros::service::call(ros::this_node::getName() + "/unload_nodelet", call);
  if (!has_manager) ros::requestShutdown();
}

/// Creates the node in onInit() and runs it in a thread of its own, so that it does not block the manager.
template <typename Node>
class CrowdNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      // Unloading waits for the thread of the node, so another thread must request it.
      thread_ = std::make_unique<NodeThread<Node>>(getNodeHandle(), getPrivateNodeHandle(), getName(),
                                                   [name = getName()] { std::thread(unload, name).detach(); });
    } catch (const std::exception& error) {
      NODELET_FATAL("%s", error.what());
      throw;
    }
  }

  std::unique_ptr<NodeThread<Node>> thread_;
};

using CrowdControllerNodelet = CrowdNodelet<CrowdController>;
using CrowdMarkersNodelet = CrowdNodelet<CrowdMarkers>;
using LearnerNodelet = CrowdNodelet<LearnerNode>;

}  // namespace
}  // namespace crowd

PLUGINLIB_EXPORT_CLASS(crowd::CrowdControllerNodelet, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(crowd::CrowdMarkersNodelet, nodelet::Nodelet)
PLUGINLIB_EXPORT_CLASS(crowd::LearnerNodelet, nodelet::Nodelet)
