#pragma once

#include <ros/ros.h>
#include <social_crowd/RobotObservation.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "social_crowd/ros/controller_parameters.h"
#include "social_crowd/ros/main_loop.h"
#include "social_crowd/ros/robot_interface.h"
#include "social_crowd/simulation/episode.h"
#include "social_crowd/simulation/robot_commands.h"
#include "social_crowd/simulation/robot_senses.h"

namespace crowd {

/// @brief Commands, sensors and topics of all robots of the crowd controller, which calls begin() for each episode,
/// then ask(), wait(), observe() and publish() in each tick. Without robots it advertises and publishes nothing. All
/// functions run in the main loop, which wait() serves. docs/protocol.md describes the protocol.
class RobotInterfaces {
 public:
  /// Commands by robot.
  using Commands = std::map<RobotId, Twist>;

  /// @param node whose callbacks `loop` serves
  RobotInterfaces(MainLoop& loop, const ros::NodeHandle& node, const ControllerParameters& parameters);

  /// @brief Begins an episode, which must outlive the next call; a wait() in progress ends.
  void begin(Episode& episode);
  /// @brief The commands of the coming tick are awaited from now on.
  void ask();
  /// @brief Serves the main loop until no command is awaited any more, or for ~command_deadline, and hands the commands
  /// to the episode. @return false if another episode has begun or the node shuts down
  bool wait();
  /// @brief Whether a robot that is on its way to a goal has no controller in lockstep: it starts, or is absent.
  bool isAnyUnattended() const;
  /// @brief Takes note of the moves of the last tick.
  void observe() { senses_->observe(episode_->world()); }
  /// @brief Publishes transforms, states and sensors. @param begins the episode begins
  void publish(const ros::Time& now, bool begins);

  /// @brief Commands by the names of robots. @throws InputError that names what is wrong, or if there are no robots
  Commands commandsOf(const std::vector<std::string>& names, const std::vector<geometry_msgs::Twist>& commands) const;
  /// @brief From now on these commands are executed instead of those from topics, and none is awaited.
  void hold(const Commands& commands) { held_ = commands; }
  /// @brief Ends that.
  void release() { held_.reset(); }
  /// @brief What all robots observe now. @param with_scan with ranges
  std::vector<social_crowd::RobotObservation> observations(const ros::Time& now, bool with_scan);

 private:
  using Clock = ros::WallTime;

  const std::vector<Robot>& robots() const { return episode_->world().robots(); }
  std::uint64_t tick() const { return episode_->world().tick(); }
  void advertise();
  void take(RobotId robot, const Twist& command, const std::string& node);
  void takeGoal(RobotId robot, const geometry_msgs::PoseStamped& goal);
  void warnOfRefusal(RobotId robot, CommandRefusal cause, const std::string& node);
  void warnOfAbsence(const std::vector<RobotId>& absent) const;
  PublisherId numberOf(const std::string& node);
  void publishTransforms(const ros::Time& now, bool begins);
  void publishStates(const ros::Time& now);

  MainLoop& loop_;
  ros::NodeHandle node_;
  const double command_deadline_;  // [s]
  const bool publish_localisation_;
  Episode* episode_ = nullptr;
  std::unique_ptr<RobotSenses> senses_;
  RobotCommands commands_;
  std::optional<Commands> held_;
  std::vector<std::string> advertised_;  // names and namespaces of the robots
  std::vector<std::unique_ptr<RobotInterface>> interfaces_;
  ros::Publisher states_;
  std::optional<tf2_ros::TransformBroadcaster> transforms_;
  std::optional<tf2_ros::StaticTransformBroadcaster> static_transforms_;
  std::vector<std::string> publishers_;  // of commands; the index is the PublisherId
  std::set<std::tuple<RobotId, CommandRefusal, PublisherId>> warned_;
  bool cancelled_ = false;
  Clock deadline_;
};

}  // namespace crowd
