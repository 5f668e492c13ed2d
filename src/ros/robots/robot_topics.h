#pragma once

#include <ros/ros.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "robots/robot_senses.h"
#include "ros/messages/topic_group.h"
#include "ros/robots/people_topics.h"
#include "ros/robots/robot_messages.h"
#include "world/world.h"

namespace crowd {

/// @brief Topics and frames of one robot, in its namespace.
class RobotTopics {
 public:
  /// @param node whose callbacks the main loop serves
  RobotTopics(const ros::NodeHandle& node, const RobotStart& start, RobotId id);
  RobotTopics(const RobotTopics&) = delete;
  RobotTopics& operator=(const RobotTopics&) = delete;

  /// @brief Calls handle(message, node) for each message, with the name of the node that published it.
  template <typename Message, typename Handle>
  void subscribe(const std::string& topic, Handle handle, const ros::TransportHints& hints = {}) {
    using Event = ros::MessageEvent<const Message>;
    const boost::function<void(const Event&)> take = [handle = std::move(handle)](const Event& event) {
      handle(*event.getMessage(), event.getPublisherName());
    };
    subscribers_.push_back(own_.subscribe<Message>(topic, QUEUE, take, ros::VoidConstPtr(), hints));
  }
  /// @brief The robot has another id now.
  void setId(RobotId id) { id_ = id; }
  /// @brief Publishes what subscribers see of the robot after a tick; its scan if it is due.
  void publish(const World& world, RobotSenses& senses, const ros::Time& now);
  /// @brief Publishes the present goal again, if it has changed or an episode begins.
  void publishGoal(const Robot& robot, const ros::Time& now, bool begins);
  /// @brief An episode begins. @param start of a robot of the same name and namespace
  void begin(const RobotStart& start) { start_ = start; }

  /// @brief Publishes the odometry of a time for subscribers.
  void publishOdometry(const Odometry& odometry, const OdometryCovariance& covariance, const ros::Time& time);
  /// @brief Appends the transforms map -> odom, if it is given, and odom -> base_link.
  void addTransforms(const std::optional<Pose>& odom_in_map, const Odometry& odometry, const ros::Time& time,
                     std::vector<geometry_msgs::TransformStamped>& transforms) const;
  /// @brief The transform base_link -> laser, which never changes.
  geometry_msgs::TransformStamped mountTransform(const ros::Time& now) const;

  /// @brief Scan of the robot as a message. @param ranges may be empty
  sensor_msgs::LaserScan scanMessage(const std::vector<float>& ranges, double tick_duration,
                                     const ros::Time& now) const;

 private:
  /// What messages are made from.
  struct Tick {
    const World& world;
    RobotSenses& senses;
    ros::Time now;
  };

  void publishPeople(const Tick& tick);
  std_msgs::Header header(const std::string& frame, const ros::Time& now) const;
  /// The message with a header.
  template <typename Message>
  Message stamped(Message message, const std::string& frame, const ros::Time& now) const {
    message.header = header(frame, now);
    return message;
  }

  ros::NodeHandle own_;  // the robot's namespace
  RobotId id_;
  RobotStart start_;
  std::string prefix_;  // of frames
  std::optional<Vector2> goal_;
  ros::Publisher odometry_;
  TopicGroup<const Tick&> scan_topics_;  // when a scan is due
  PeopleTopics people_;
  TopicGroup<const Tick&> tick_topics_;
  ros::Publisher goals_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace crowd
