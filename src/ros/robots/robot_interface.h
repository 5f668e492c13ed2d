#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <ros/ros.h>
#include <social_crowd/RobotObservation.h>
#include <social_crowd/RobotStates.h>
#include <social_crowd/StepRobots.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robots/robot_senses.h"
#include "ros/node/main_loop.h"
#include "ros/robots/command_collector.h"
#include "ros/robots/pose_collector.h"
#include "ros/robots/robot_parameters.h"
#include "ros/robots/robot_topics.h"
#include "ros/robots/robot_transforms.h"
#include "simulation/episode.h"

namespace crowd {

/// @brief Commands, poses, sensors and topics of all robots of the crowd controller, which calls begin() for each
/// episode, then ask(), wait(), observe() and publish() in each tick. Without robots it advertises and publishes
/// nothing. All functions run in the main loop, which wait() serves. docs/protocol.md describes the protocol.
class RobotInterface {
 public:
  /// @param node whose callbacks `loop` serves @param clock the present time, simulated time with ~publish_clock
  RobotInterface(MainLoop& loop, const ros::NodeHandle& node, const RobotParameters& parameters,
                 std::function<ros::Time()> clock);

  /// @brief Begins an episode, which must outlive the next call; a wait() in progress ends.
  void begin(Episode& episode);
  /// @brief Adds a robot to the episode. @throws InputError, see EpisodeEditor::addRobot(), or during beginSteps()
  void add(const RobotStart& start);
  /// @brief Removes a robot from the episode. @throws InputError, see EpisodeEditor::removeRobot(), or as above
  void remove(const std::string& name);
  /// @brief The commands of the coming tick are awaited from now on.
  void ask() { commands_.ask(); }
  /// @brief Waits for the commands of the tick and moves external robots. @return see CommandCollector::wait()
  /// @param end returns the time of the end of the tick
  bool wait(const std::function<ros::Time()>& end);
  /// @brief At the end of an episode: see CommandCollector::awaitLast().
  bool awaitLast() { return robots().empty() || commands_.awaitLast(); }
  /// @brief Takes note of the moves of the last tick.
  void observe();
  /// @brief Publishes transforms, states and sensors. @param begins the episode begins
  void publish(const ros::Time& now, bool begins);
  /// @brief Publishes the states if a user has changed the world since they were published last.
  void publishChanges();

  const CommandCollector& commands() const { return commands_; }
  /// @brief Writes what the robots got from elsewhere in this episode.
  void writeInput(std::vector<RobotResult>& results) const;
  /// @brief From now on these commands are executed instead of those from topics, none is awaited, and contacts are
  /// collected.
  void beginSteps(const CommandCollector::Commands& commands);
  /// @brief Ends that.
  void endSteps();
  /// @brief What all robots observe now, with the contacts of all ticks since beginSteps(), or, without that, of the
  /// last tick. @param wanted says what they contain
  std::vector<social_crowd::RobotObservation> observations(const ros::Time& now,
                                                           const social_crowd::StepRobots::Request& wanted);

 private:
  const std::vector<Robot>& robots() const { return episode_->world().robots().list(); }
  RobotInput inputOf(RobotId robot) const;
  void advertise();
  std::unique_ptr<RobotTopics> topicsOf(const RobotStart& start, RobotId id);
  void requireFreeHands() const;
  void noteRobots();
  void advertiseAll();
  void noteNavigation(RobotId robot, const std::string& state);
  std::string navigationOf(RobotId robot) const;
  void takePose(RobotId robot, const geometry_msgs::PoseWithCovarianceStamped& pose);
  /// Lets a user change a robot; a warning says why that is refused. @param what is sent @param frame of it
  template <typename Change>
  bool change(RobotId robot, const char* what, const std::string& frame, const Change& change);
  void takeGoal(RobotId robot, const geometry_msgs::PoseStamped& goal);
  social_crowd::RobotStates states(const ros::Time& now) const;
  void publishStates(const ros::Time& now);

  ros::NodeHandle node_;
  std::function<ros::Time()> clock_;
  RobotTransforms transforms_;
  const bool visible_people_only_;
  Episode* episode_ = nullptr;
  std::unique_ptr<RobotSenses> senses_;
  std::uint64_t scanned_changes_ = 0;                // Episode::changes() at the last scans
  std::uint64_t published_changes_ = 0;              // the same at the last states
  std::vector<std::vector<RobotContact>> contacts_;  // by robot; empty: they are not collected
  CommandCollector commands_;
  PoseCollector poses_;
  std::vector<std::string> navigation_;  // by robot: what it has said last; empty: nothing
  std::vector<bool> has_crashed_;        // by robot: its navigation, in this episode or before
  std::vector<std::string> advertised_;  // names and namespaces of the robots
  std::vector<std::unique_ptr<RobotTopics>> topics_;
  ros::Publisher states_;
};

}  // namespace crowd
