#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "common/object_pool.h"

namespace crowd {

/// @brief Subscribes to a topic that is published in each tick, with tcpNoDelay. Messages are deserialised into reused
/// buffers.
/// @param take is called with each message and the name of the node that published it
template <typename Message>
ros::Subscriber subscribeToTicks(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue,
                                 const std::function<void(const ros::MessageEvent<const Message>&)>& take) {
  const auto messages = std::make_shared<ObjectPool<typename Message::Ptr>>();
  ros::SubscribeOptions options;
  options.initByFullCallbackType<const ros::MessageEvent<const Message>&>(topic, queue, take,
                                                                          [messages] { return messages->next(); });
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  return node.subscribe(options);
}

}  // namespace crowd
