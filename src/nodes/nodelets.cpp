// The nodes as nodelets: several of them in one process, where they exchange pointers instead of messages.

#include <nodelet/NodeletUnload.h>
#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>
#include <string>
#include <thread>

#include "social_crowd/ros/crowd_controller.h"
#include "social_crowd/ros/crowd_markers.h"
#include "social_crowd/ros/learner_node.h"
#include "social_crowd/ros/node_thread.h"

namespace crowd {
namespace {

/// Asks the manager to take a nodelet away that has nothing left to do, so that whoever loaded it is told. Where there
/// is no manager, the process is the nodelet's alone.
void unload(const std::string& name) {
  nodelet::NodeletUnload call;
  call.request.name = name;
  const bool has_manager = ros::service::call(ros::this_node::getName() + "/unload_nodelet", call);
  if (!has_manager) ros::requestShutdown();
}

/// Does not hold up its manager: the node begins in onInit(), and runs in a thread of its own.
template <typename Node>
class CrowdNodelet : public nodelet::Nodelet {
 private:
  void onInit() override {
    try {
      // Unloading waits for the node's thread, so another one has to ask for it.
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
