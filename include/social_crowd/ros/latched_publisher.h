#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <string>

namespace crowd {

/// @brief Publishes a topic by pointer and tells the last message to whoever comes later. ROS's own latching would
/// write out every message for somebody who may come; here newcomers are served when they come, from the queue of the
/// node handle.
template <typename Message>
class LatchedPublisher {
 public:
  LatchedPublisher(ros::NodeHandle& node, const std::string& topic, std::uint32_t queue)
      : publisher_(node.advertise<Message>(topic, queue, [this](const ros::SingleSubscriberPublisher& newcomer) {
          if (last_ != nullptr) newcomer.publish(*last_);
        })) {}
  LatchedPublisher(const LatchedPublisher&) = delete;
  LatchedPublisher& operator=(const LatchedPublisher&) = delete;

  /// @brief The message must not change any more.
  void publish(const typename Message::ConstPtr& message) {
    last_ = message;
    publisher_.publish(message);
  }
  /// @brief The last message once more, if there is one.
  void repeat() const {
    if (last_ != nullptr) publisher_.publish(last_);
  }
  /// @brief The last message; null if there is none yet.
  const typename Message::ConstPtr& last() const { return last_; }

 private:
  typename Message::ConstPtr last_;
  ros::Publisher publisher_;
};

}  // namespace crowd
