#pragma once

#include <ros/ros.h>
#include <social_crowd/LearnerStatus.h>

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "ros/controller/answering_learners.h"
#include "ros/controller/controller_parameters.h"
#include "ros/controller/learner_visions.h"
#include "ros/controller/perceptions_publisher.h"
#include "ros/messages/tick_messages.h"
#include "ros/node/main_loop.h"
#include "simulation/episode.h"
#include "simulation/lockstep.h"

namespace crowd {

/// @brief Answers that were not executed, or did not come.
struct AnswerCounts {
  std::uint64_t missed = 0;
  std::uint64_t dropped = 0;
  std::uint64_t late = 0;  ///< of those dropped
};

/// @brief Publishes perceptions and waits for the learners' answers, with deadlines. Owned by CrowdController, which
/// calls ask() and then wait() once per turn. All functions run in the main loop, which wait() serves. docs/protocol.md
/// describes the protocol.
class AnswerCollector {
 public:
  /// @param node whose callbacks `loop` serves @param parameters of the owner, which may change between two calls
  AnswerCollector(MainLoop& loop, ros::NodeHandle& node, const ControllerParameters& parameters);

  /// @brief Publishes the perceptions of the present turn of the episode and starts to accept answers.
  void ask(Episode& episode, const std_msgs::Header& header);
  /// @brief Serves the main loop until no answer is awaited any more.
  /// @return false if the answers are void: cancel() was called, the node shuts down, or ask() has to be called again
  bool wait(const Episode& episode);
  /// @brief Abandons the present turn because another episode begins. May be called while wait() serves the main loop.
  void cancel();
  /// @brief Publishes the last perceptions of an episode; no answer is awaited.
  void publishLast(Episode& episode, const std_msgs::Header& header);

  const std::vector<AgentAction>& answers() const { return lockstep_.answers(); }
  /// @brief Agents on their way without an answer for more than a second.
  std::vector<AgentId> unanswered(const World& world) const;
  std::uint64_t missedCount() const { return lockstep_.missedCount(); }
  std::uint64_t droppedCount() const { return lockstep_.droppedCount(); }
  /// @brief Counts of all episodes.
  AnswerCounts totals() const;

 private:
  using Clock = ros::WallTime;

  PerceptionsMessage::ConstPtr toMessage(Episode& episode, const std_msgs::Header& header) const;
  void take(const ros::MessageEvent<const ActionsMessage>& event);
  void takeStatus(const ros::MessageEvent<const social_crowd::LearnerStatus>& event);
  void useWidestVision(Episode& episode);
  /// Makes the perceptions of the present turn again with the widest vision and publishes them. Answers that were
  /// already accepted stay valid.
  void askWithWiderVision();
  bool isInterrupted() const { return cancelled_ || is_outdated_ || loop_.isClosed(); }
  void endWait();
  void serveUntil(const Clock& deadline);
  /// The moment at which a timeout [s] for the present turn is over.
  Clock deadlineOf(double timeout) const { return asked_at_ + ros::WallDuration(timeout); }
  void awaitPresent();
  void awaitNewcomers(const Episode& episode);
  void giveUpOnNewcomers(const Episode& episode);
  void awaitAny(const Episode& episode);
  void askAgain();
  void noteSilence(const std::vector<AgentId>& asked);
  void noteAnswers();
  void warnOfSilence();
  void warnOfAbsence(const std::vector<AgentId>& agents);
  std::string reasonForSilence() const;
  double silence(const std::vector<AgentId>& agents) const;

  const ControllerParameters& parameters_;
  const std::uint64_t run_;  // number of this run of the controller
  MainLoop& loop_;
  Lockstep lockstep_;
  AnsweringLearners learners_;
  PerceptionsPublisher perceptions_;
  std::set<std::string> deciding_;  // learners with an answer in this episode that was taken
  LearnerVisions visions_;
  ros::Subscriber actions_;
  ros::Subscriber status_;

  Episode* asked_episode_ = nullptr;  // while answers are awaited
  std_msgs::Header header_;           // of the present turn
  std::vector<AgentId> asked_;        // agents of the present turn
  AnswerCounts earlier_;              // of earlier episodes; `late` of all
  bool cancelled_ = false;
  bool is_outdated_ = false;  // the perceptions of the present turn cannot be made again
  Clock asked_at_;
  Clock ask_again_at_;
  ros::WallDuration ask_again_after_;
  AgentMap<Clock> silent_since_;  // first tick without an answer since the agent's last answer; zero: none
  Clock last_warning_;
};

}  // namespace crowd
