#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <string>

namespace crowd {

/// @brief Latched publisher that publishes by pointer. Unlike ROS's own latching it does not serialise each message:
/// the last message is sent when a subscriber connects, from the callback queue of the node handle.
template <typename Message>
class LatchedPublisher {
 public:
  LatchedPublisher(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue)
      : publisher_(node.advertise<Message>(topic, queue, [this](const ros::SingleSubscriberPublisher& subscriber) {
          if (last_ != nullptr) subscriber.publish(*last_);
        })) {}
  LatchedPublisher(const LatchedPublisher&) = delete;
  LatchedPublisher& operator=(const LatchedPublisher&) = delete;

  /// @brief Publishes a message, which must not change afterwards.
  void publish(const typename Message::ConstPtr& message) {
    last_ = message;
    publisher_.publish(message);
  }
  /// @brief Publishes the last message again, if there is one.
  void repeat() const {
    if (last_ != nullptr) publisher_.publish(last_);
  }
  /// @brief Returns the last message, or null.
  const typename Message::ConstPtr& last() const { return last_; }

 private:
  typename Message::ConstPtr last_;
  ros::Publisher publisher_;
};

}  // namespace crowd
