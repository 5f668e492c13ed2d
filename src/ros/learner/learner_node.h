#pragma once

#include <ros/ros.h>
#include <social_crowd/LearnerStatus.h>
#include <social_crowd/ShareQTable.h>
#include <social_crowd/TakeQTable.h>

#include <map>
#include <string>
#include <vector>

#include "common/object_pool.h"
#include "learning/learner.h"
#include "ros/learner/decision_publisher.h"
#include "ros/learner/learner_diagnostics.h"
#include "ros/learner/learner_parameters.h"
#include "ros/learner/learner_settings.h"
#include "ros/learner/share_report.h"
#include "ros/messages/latched_publisher.h"
#include "ros/messages/perception_limiter.h"
#include "ros/messages/tick_messages.h"
#include "ros/node/diagnostics_publisher.h"
#include "ros/node/main_loop.h"
#include "ros/node/reconfigure_server.h"
#include "ros/node/services.h"

namespace crowd {

/// @brief Node that owns Q-tables: it answers perceptions with relative actions for one or more agents, learns, and
/// saves, loads and shares Q-tables.
class LearnerNode {
 public:
  /// @throws InputError that lists invalid parameters
  LearnerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// @brief Answers perceptions until stop() is called or ROS shuts down; then saves the table to ~save_to.
  void run();
  /// @brief Makes run() return soon. Thread-safe.
  void stop() { loop_.close(); }

 private:
  LearnerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node, LearnerParameters parameters);

  void takePerceptions(const PerceptionsMessage& message);
  void answer(const PerceptionsMessage& message);
  /// Whether the last answer is to this message, which the controller may publish again.
  bool isRepeated(const PerceptionsMessage& message) const;
  std::size_t countToAnswer(const Perceptions& perceptions) const;
  /// Whether the perceptions contain what the model needs. If not, the controller has not received the status of this
  /// learner yet and will publish them again.
  bool isSufficient(const PerceptionsMessage& message);
  /// Whether perceptions have been insufficient for longer than the controller needs to receive the status.
  bool lacksVision() const;
  void noteEpisode();
  LearnerSettings settings() const { return {learner_.mode(), learner_.plan()}; }
  /// Changes mode and learning parameters, for services and dynamic_reconfigure. @throws InputError; nothing has
  /// changed then
  void use(const LearnerSettings& settings);
  void addDiagnostics();
  void takeSample();
  /// Publishes the status again while the topic with the perceptions of its agents has no publisher.
  void askForPerceptions();
  /// Whether its process may contain other learners.
  bool isNodelet() const { return name_ != ros::this_node::getName(); }
  void noteStatus(const social_crowd::LearnerStatus::ConstPtr& status);
  void publishStatus();
  social_crowd::LearnerStatus status() const;

  /// The agent whose table is used where one agent is needed.
  AgentId firstAgent() const;
  TrainedTable trained(QTable table) const;

  // learner_node_services.cpp
  /// Writes ~save_to. @param goes_on whether learning continues
  void saveAll(bool goes_on);
  void requireServed(AgentId agent) const;
  /// Returns the agent that a request refers to. If there is only one table, 0 means its agent.
  AgentId meant(AgentId agent) const;
  void advertiseServices();

  // learner_sharing.cpp
  void share(const social_crowd::ShareQTable::Request& request, social_crowd::ShareQTable::Response& response);
  void take(const social_crowd::TakeQTable::Request& request, social_crowd::TakeQTable::Response& response);
  /// Gives a table to these agents; if the list is empty, to all.
  TakeReport giveTo(const std::vector<AgentId>& agents, QTable table, TakeMethod method);
  void shareWithin(const std::vector<AgentId>& agents, AgentId from, const QTable& table, TakeMethod method,
                   ShareReport& report);

  MainLoop loop_;
  ros::NodeHandle node_;
  std::string name_;  // of the node; its services are below it
  TakeMethod on_share_;
  std::string save_to_;
  const DataFolder data_folder_;
  std::uint64_t save_every_;
  ThreadPool thread_pool_;
  Learner learner_;
  PerceptionLimiter limiter_;

  ObjectPool<ActionsMessage::Ptr> replies_;
  std::uint64_t run_ = 0;            // of the last perceptions
  std::uint64_t episode_ = 0;        // of the last perceptions
  std::uint64_t tick_ = 0;           // of the last perceptions
  std::uint32_t answered_turn_ = 0;  // of the last answer
  std::uint64_t episodes_ = 0;       // number of episodes begun
  std::uint64_t answered_ = 0;       // decisions since the start of the node
  ros::WallTime last_perceptions_;
  ros::WallTime last_status_;
  ros::WallTime insufficient_since_;                           // zero: the last perceptions were sufficient
  std::map<std::string, social_crowd::LearnerStatus> others_;  // other learners, by node name

  LatchedPublisher<ActionsMessage> actions_publisher_;
  DecisionPublisher decision_publisher_;
  ros::Publisher status_publisher_;
  ros::Subscriber perceptions_subscriber_;
  ros::Subscriber status_subscriber_;

  const LiveParameters<LearnerSettings> live_ = liveLearnerParameters();
  ReconfigureServer reconfigure_;
  LearnerSample last_sample_;
  LearnerSample sample_;
  DiagnosticsPublisher diagnostics_;

  // Threads of their own: learners that share at the same time must not wait for each other, and neither files nor
  // other learners hold up the services that change the learning.
  Services taking_;
  Services sharing_;
  Services files_;
  Services services_;  // last member: its threads use all others
};

}  // namespace crowd
