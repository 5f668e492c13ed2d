#pragma once

#include <ros/publisher.h>

#include <cstdint>

namespace crowd {

/// @brief Publishes a message of a latched topic. roscpp sends a message first and keeps it for later subscribers
/// afterwards, so that one that connects between these two steps receives none. It is sent again if somebody did.
template <typename Message>
void publishLatched(const ros::Publisher& publisher, const Message& message) {
  std::uint32_t subscribers = 0;
  do {
    subscribers = publisher.getNumSubscribers();
    publisher.publish(message);
  } while (publisher.getNumSubscribers() > subscribers);
}

}  // namespace crowd
