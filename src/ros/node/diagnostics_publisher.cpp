#include "ros/node/diagnostics_publisher.h"

#include <utility>

namespace crowd {

DiagnosticsPublisher::DiagnosticsPublisher(ros::NodeHandle node, const ros::NodeHandle& private_node, double period,
                                           std::function<void()> sample)
    : sample_(std::move(sample)), updater_(node, private_node, private_node.getNamespace()) {
  updater_.setHardwareID("none");
  // Publishers of one topic in one process share their connections, so this one has the updater's subscribers.
  watchers_ = node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1);
  // Updater::update() measures its period with ROS time, which may run a thousand times faster than the wall clock.
  timer_ = node.createWallTimer(ros::WallDuration(period), [this](const ros::WallTimerEvent& /*event*/) { update(); });
}

void DiagnosticsPublisher::update() {
  sample_();
  if (watchers_.getNumSubscribers() > 0) updater_.force_update();
}

double rateOf(std::uint64_t events, double seconds) {
  return seconds > 0.0 ? static_cast<double>(events) / seconds : 0.0;
}

}  // namespace crowd
