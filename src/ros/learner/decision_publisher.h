#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <string>

#include "learning/learner.h"
#include "ros/messages/tick_messages.h"

namespace crowd {

/// @brief Publishes what the chosen agent chose from, on `decision_values`. Without subscribers nothing is computed,
/// and the node does not subscribe to `chosen_agent`.
///
/// Used by LearnerNode in its thread; callbacks come from the queue of the node handle.
class DecisionPublisher {
 public:
  /// @param node_name full name of the learner
  DecisionPublisher(const ros::NodeHandle& node, std::string node_name);
  DecisionPublisher(const DecisionPublisher&) = delete;
  DecisionPublisher& operator=(const DecisionPublisher&) = delete;

  /// @brief Publishes the values of the last call of decide(), if somebody listens and the chosen agent decided.
  /// @param perceptions those that the learner was given
  void publish(const Learner& learner, const Perceptions& perceptions, const ActionsMessage& answer);

 private:
  static constexpr std::int64_t NO_AGENT = -1;

  void subscribeToChoice(bool wanted);

  ros::NodeHandle node_;
  std::string node_name_;
  std::int64_t agent_ = NO_AGENT;
  ros::Subscriber chosen_;    // only while there are subscribers
  ros::Publisher publisher_;  // last member: its callbacks use all others
};

}  // namespace crowd
