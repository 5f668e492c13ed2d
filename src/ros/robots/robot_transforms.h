#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <ros/ros.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <memory>
#include <optional>
#include <vector>

#include "robots/robot_senses.h"
#include "ros/robots/robot_parameters.h"
#include "ros/robots/robot_topics.h"

namespace crowd {

/// @brief The transforms of all robots, and their odometry at times between two ticks. Robots are listed by id.
class RobotTransforms {
 public:
  using Topics = std::vector<std::unique_ptr<RobotTopics>>;

  explicit RobotTransforms(const RobotParameters& parameters)
      : publish_localisation_(parameters.publish_localisation), odometry_rate_(parameters.odometry_rate) {}

  /// @brief Call it before the functions below.
  void advertise();
  /// @brief Publishes map -> odom and odom -> base_link of the end of the last tick.
  void publish(const std::vector<Robot>& robots, const RobotSenses& senses, const Topics& topics, const ros::Time& now);
  /// @brief Publishes odometry and transforms at times of the last tick, at ~odometry_rate. Call it before publish().
  void publishBetween(const World& world, const RobotSenses& senses, const Topics& topics, const ros::Time& now);
  /// @brief Publishes base_link -> laser.
  void publishMounts(const Topics& topics, const ros::Time& now);
  /// @brief Forgets a robot; those after it get smaller ids.
  void remove(RobotId id);

 private:
  const bool publish_localisation_;
  const double odometry_rate_;
  std::vector<Odometry> last_odometry_;                   // by robot: that of the tick before
  std::vector<std::optional<Pose>> last_odom_;            // by robot: map -> odom that was published in the tick before
  std::vector<geometry_msgs::TransformStamped> between_;  // scratch
  std::optional<tf2_ros::TransformBroadcaster> transforms_;
  std::optional<tf2_ros::StaticTransformBroadcaster> static_transforms_;
};

}  // namespace crowd
