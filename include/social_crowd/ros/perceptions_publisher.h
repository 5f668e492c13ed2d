#pragma once

#include <ros/ros.h>

#include <map>
#include <string>
#include <vector>

#include "social_crowd/ros/tick_messages.h"

namespace crowd {

/// @brief Publishes the perceptions of a tick, or in a sequential scenario of a turn: once to all subscribers, and,
/// while answers are awaited, to each subscriber that connects. Owned by AnswerCollector; all functions and callbacks
/// run in the main loop.
///
/// The first answer of a node that connects late may be lost, because ROS does not report whether the publisher of that
/// node is already connected. Within one process a second subscriber is not reported at all. In these cases, see
/// isAnyUnheard(), the message is published again.
class PerceptionsPublisher {
 public:
  /// @param node its queue serves the callbacks
  explicit PerceptionsPublisher(ros::NodeHandle& node);
  PerceptionsPublisher(const PerceptionsPublisher&) = delete;
  PerceptionsPublisher& operator=(const PerceptionsPublisher&) = delete;

  /// @brief Publishes perceptions. The message must not change afterwards.
  /// @param awaited whether answers are awaited: the message is then also sent to subscribers that connect before
  /// endWait()
  void publish(const PerceptionsMessage::ConstPtr& message, bool awaited);
  /// @brief Publishes the present perceptions again if answers are awaited.
  void publishAgain() const;
  void endWait() { awaited_.reset(); }

  /// @brief Records that a node has answered the perceptions of this controller.
  void markHeard(const std::string& node);
  /// @brief Whether one of these nodes subscribes and has not answered within a short time after it connected.
  bool isAnyUnheard(const std::vector<std::string>& nodes) const;

 private:
  struct Subscriber {
    ros::WallTime since;
    bool heard = false;
  };
  void addSubscriber(const ros::SingleSubscriberPublisher& subscriber);

  std::map<std::string, Subscriber> subscribers_;  // by name of the node; includes former ones
  PerceptionsMessage::ConstPtr awaited_;
  ros::Publisher publisher_;
};

}  // namespace crowd
