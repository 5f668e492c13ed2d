#pragma once

#include <ros/ros.h>
#include <social_crowd/LearnerStatus.h>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ros/messages/perception_routes.h"
#include "ros/messages/tick_messages.h"

namespace crowd {

/// @brief Publishes the perceptions of a tick, or in a sequential scenario of a turn: once to all subscribers, and,
/// while answers are awaited, to each subscriber that connects. Owned by AnswerCollector; all functions and callbacks
/// run in the main loop.
///
/// A learner with agents of its own may name a topic in its status. On this topic the perceptions of its agents are
/// published, in those turns in which one of them is perceived, at the start of an episode and at its end.
///
/// The first answer of a node that connects late may be lost, because ROS does not report whether the publisher of that
/// node is already connected. Within one process a second subscriber is not reported at all. In these cases, see
/// isAnyUnheard(), the message is published again.
class PerceptionsPublisher {
 public:
  /// @param node its queue serves the callbacks
  explicit PerceptionsPublisher(const ros::NodeHandle& node);
  PerceptionsPublisher(const PerceptionsPublisher&) = delete;
  PerceptionsPublisher& operator=(const PerceptionsPublisher&) = delete;

  /// @brief Publishes perceptions. The message must not change afterwards.
  /// @param awaited whether answers are awaited: the message is then also sent to subscribers that connect before
  /// endWait()
  void publish(const PerceptionsMessage::ConstPtr& message, bool awaited);
  /// @brief Publishes the present perceptions again if answers are awaited.
  void publishAgain();
  void endWait() { awaited_.reset(); }

  /// @brief Uses the topic that a learner names in its status from now on, in place of the one that it named before.
  /// Refuses invalid ones with a warning, once for each learner and cause.
  /// @param learner full name of its node
  void useTopicOf(const std::string& learner, const social_crowd::LearnerStatus& status);

  /// @brief Records that a node has answered the perceptions of this controller.
  void markHeard(const std::string& node);
  /// @brief Whether one of these nodes subscribes and has not answered within a short time after it connected.
  bool isAnyUnheard(const std::vector<std::string>& nodes) const;

 private:
  struct Subscriber {
    ros::WallTime since;
    bool heard = false;
  };
  /// Topic of the agents of a learner.
  struct OwnTopic {
    ros::Publisher publisher;
    std::optional<std::uint64_t> episode;  // of the last message
  };
  void addSubscriber(const ros::SingleSubscriberPublisher& subscriber);
  void addSubscriberOf(const std::string& topic, const ros::SingleSubscriberPublisher& subscriber);
  /// Returns what is wrong with the topic of a learner; empty: nothing.
  std::string problemOf(const social_crowd::LearnerStatus& status) const;
  /// Advertises the claimed topics, and no others.
  void updateTopics();
  OwnTopic advertise(const std::string& topic);
  void publishOwn(const PerceptionsMessage& all, bool again);
  /// Publishes the present perceptions again on the topic of a learner if answers of its agents are awaited.
  void publishAgainOn(const std::string& topic);

  ros::NodeHandle node_;
  std::map<std::string, Subscriber> subscribers_;  // by name of the node; includes former ones
  PerceptionsMessage::ConstPtr awaited_;
  ros::Publisher publisher_;
  PerceptionRoutes routes_;
  std::map<std::string, OwnTopic> own_;                 // by name: the topics of routes_
  std::set<std::pair<std::string, std::string>> told_;  // learners and causes that were warned of
};

}  // namespace crowd
