#pragma once

#include <ros/ros.h>

#include <map>
#include <string>
#include <vector>

#include "social_crowd/ros/tick_messages.h"

namespace crowd {

/// @brief Publishes the perceptions of a tick, or in a sequential scenario of a turn: once to all subscribers, and
/// while answers are awaited to each subscriber that connects. Owned by AnswerCollector, which calls it in the node's
/// main loop; its callbacks run there as well.
///
/// Who connects late is the one case in which a message is sent again: ROS does not tell a publisher whether its
/// subscriber's own publisher is connected already, so the first answer of a node may be lost. Within one process a
/// second subscriber is not announced at all. isAnyUnheard() tells when to ask again.
class PerceptionsPublisher {
 public:
  /// @param node callbacks are served by its queue
  explicit PerceptionsPublisher(ros::NodeHandle& node);
  PerceptionsPublisher(const PerceptionsPublisher&) = delete;
  PerceptionsPublisher& operator=(const PerceptionsPublisher&) = delete;

  /// @brief Sends perceptions to all subscribers. Nothing may change the message from now on.
  /// @param awaited whether answers are awaited: subscribers that connect before endWait() are sent it as well
  void publish(const PerceptionsMessage::ConstPtr& message, bool awaited);
  /// @brief Sends the awaited perceptions to all subscribers once more.
  void publishAgain() const;
  void endWait() { awaited_.reset(); }

  /// @brief Records that a node has answered the perceptions of this controller.
  void markHeard(const std::string& node);
  /// @brief Whether one of these nodes subscribes, has had time to answer, and has not answered since it connected.
  bool isAnyUnheard(const std::vector<std::string>& nodes) const;

 private:
  struct Subscriber {
    ros::WallTime since;
    bool heard = false;
  };
  void addSubscriber(const ros::SingleSubscriberPublisher& subscriber);

  std::map<std::string, Subscriber> subscribers_;  // by name of the node; also former ones, which publish no answers
  PerceptionsMessage::ConstPtr awaited_;
  ros::Publisher publisher_;
};

}  // namespace crowd
