#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Twist.h>
#include <ros/ros.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robots/robot_senses.h"
#include "ros/robots/people_topics.h"
#include "ros/robots/robot_messages.h"
#include "world/world.h"

namespace crowd {

/// @brief Topics and frames of one robot, in its namespace.
class RobotTopics {
 public:
  /// What happens with messages.
  struct Handlers {
    std::function<void(const Twist& command, const std::string& node)> command;
    std::function<void(const geometry_msgs::PoseStamped& goal)> goal;
    std::function<void(const std::string& state)> navigation;
    std::function<void(const geometry_msgs::PoseWithCovarianceStamped& pose)> pose;
  };

  /// @param node whose callbacks the main loop serves
  RobotTopics(const ros::NodeHandle& node, const RobotStart& start, RobotId id, Handlers handlers);

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
  void publishScan(const World& world, RobotSenses& senses, const ros::Time& now);
  void publishPeople(const World& world, RobotSenses& senses, const ros::Time& now);
  std_msgs::Header header(const std::string& frame, const ros::Time& now) const;

  RobotId id_;
  RobotStart start_;
  std::string prefix_;  // of frames
  std::optional<Vector2> goal_;
  ros::Publisher odometry_;
  ros::Publisher scan_;
  ros::Publisher cloud_;
  ros::Publisher points_;  // of a robot with rings
  std::optional<PeopleTopics> people_;
  ros::Publisher footprint_;
  ros::Publisher goals_;
  ros::Subscriber commands_;
  ros::Subscriber new_goals_;
  ros::Subscriber navigation_;
  ros::Subscriber new_poses_;
};

}  // namespace crowd
