#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "social_crowd/common/recycler.h"

namespace crowd {

/// @brief Subscribes to a topic of every tick: no waiting in the network, and what comes over the wire is read into
/// messages that are used again.
template <typename Message>
ros::Subscriber subscribeToTicks(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue,
                                 const std::function<void(const typename Message::ConstPtr&)>& take) {
  const auto messages = std::make_shared<Recycler<typename Message::Ptr>>();
  ros::SubscribeOptions options;
  options.init<Message>(topic, queue, take, [messages] { return messages->next(); });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return node.subscribe(options);
}

}  // namespace crowd
