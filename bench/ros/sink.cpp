#include <ros/ros.h>

#include "any_message.h"
#include "commands.h"

namespace crowd::bench {

void sink(const std::vector<std::string>& topics) {
  ros::NodeHandle node;
  std::vector<ros::Subscriber> subscribers;
  subscribers.reserve(topics.size());
  for (const std::string& topic : topics) {
    const boost::function<void(const boost::shared_ptr<AnyMessage const>&)> ignore = [](const auto& /*message*/) {};
    subscribers.push_back(node.subscribe<AnyMessage>(topic, 100, ignore));
  }
  ros::spin();
}

}  // namespace crowd::bench
