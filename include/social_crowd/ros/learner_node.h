#pragma once

#include <ros/ros.h>
#include <social_crowd/LearnerStatus.h>
#include <social_crowd/ShareQTable.h>
#include <social_crowd/TakeQTable.h>

#include <map>
#include <string>
#include <vector>

#include "social_crowd/common/object_pool.h"
#include "social_crowd/learning/learner.h"
#include "social_crowd/ros/latched_publisher.h"
#include "social_crowd/ros/learner_parameters.h"
#include "social_crowd/ros/main_loop.h"
#include "social_crowd/ros/perception_limiter.h"
#include "social_crowd/ros/services.h"
#include "social_crowd/ros/share_report.h"
#include "social_crowd/ros/tick_messages.h"

namespace crowd {

/// @brief The node that owns Q-tables and nothing of the world: perceptions in, relative actions out, for one agent or
/// many; it saves, loads, takes and shares Q-tables.
class LearnerNode {
 public:
  /// @throws InputError naming bad parameters.
  LearnerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// @brief Answers perceptions until it is stopped or ROS shuts down; then saves the table, where that is asked for.
  void run();
  /// @brief From another thread: lets run() return soon.
  void stop() { loop_.close(); }

 private:
  LearnerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node, LearnerParameters parameters);

  void advertiseServices();
  void takePerceptions(const PerceptionsMessage& message);
  void answer(const PerceptionsMessage& message);
  /// Whether it was answered already: the controller may ask again (PerceptionsPublisher).
  bool isRepeated(const PerceptionsMessage& message) const;
  std::size_t countToAnswer(const Perceptions& perceptions) const;
  /// Whether the perceptions contain all that the model needs. If not, the controller has not received the status of
  /// this learner yet, and will publish them again.
  bool isSufficient(const PerceptionsMessage& message);
  void noteEpisode();
  void noteStatus(const social_crowd::LearnerStatus::ConstPtr& status);
  void publishStatus();

  /// The agent whose table stands for all where one is to be named.
  AgentId firstAgent() const;
  TrainedTable trained(QTable table) const;
  /// Writes ~save_to. @param goes_on whether learning goes on in the tables
  void saveAll(bool goes_on);
  void requireServed(AgentId agent) const;
  /// The agent that a request means by a number: 0 may stand for the only one there is, or for all that share a table.
  AgentId meant(AgentId agent) const;

  // learner_sharing.cpp
  void share(const social_crowd::ShareQTable::Request& request, social_crowd::ShareQTable::Response& response);
  void take(const social_crowd::TakeQTable::Request& request, social_crowd::TakeQTable::Response& response);
  /// Gives a table to some agents, or to all if none is named.
  TakeReport giveTo(const std::vector<AgentId>& agents, QTable table, TakeMethod method);
  void shareWithin(const std::vector<AgentId>& agents, AgentId from, const QTable& table, TakeMethod method,
                   ShareReport& report);

  MainLoop loop_;
  ros::NodeHandle node_;
  std::string name_;  // of the node; its services are below it
  TakeMethod on_share_;
  std::string save_to_;
  std::uint64_t save_every_;
  Learner learner_;
  PerceptionLimiter limiter_;

  ObjectPool<ActionsMessage::Ptr> replies_;
  std::uint64_t run_ = 0;            // of the controller heard last
  std::uint64_t episode_ = 0;        // of the last perceptions
  std::uint64_t tick_ = 0;           // of the last perceptions
  std::uint32_t answered_turn_ = 0;  // of the last answer
  std::uint64_t episodes_ = 0;       // begun
  ros::WallTime last_status_;
  ros::WallTime insufficient_since_;                           // zero: the last perceptions were sufficient
  std::map<std::string, social_crowd::LearnerStatus> others_;  // other learners, by node name

  LatchedPublisher<ActionsMessage> actions_publisher_;
  ros::Publisher status_publisher_;
  ros::Subscriber perceptions_subscriber_;
  ros::Subscriber status_subscriber_;

  // Taking waits for nobody: learners that all share at once do not wait for each other's busy threads.
  Services taking_;
  Services services_;  // last: its threads use all of the above
};

}  // namespace crowd
