#include "ros/robots/robot_transforms.h"

#include <algorithm>
#include <cmath>

namespace crowd {

void RobotTransforms::advertise() {
  transforms_.emplace();
  static_transforms_.emplace();
}

void RobotTransforms::publish(const std::vector<Robot>& robots, const RobotSenses& senses, const Topics& topics,
                              const ros::Time& now) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  last_odometry_.clear();
  last_odom_.clear();
  for (RobotId robot = 0; robot < robots.size(); ++robot) {
    const Odometry& odometry = senses.odometry(robot);
    const Pose odom = composedPose(robots[robot].pose, relativePose(odometry.pose, Pose()));
    last_odometry_.push_back(odometry);
    last_odom_.push_back(publish_localisation_ ? std::optional(odom) : std::nullopt);
    topics[robot]->addTransforms(last_odom_.back(), odometry, now, transforms);
  }
  if (!transforms.empty()) transforms_->sendTransform(transforms);
}

void RobotTransforms::publishBetween(const World& world, const RobotSenses& senses, const Topics& topics,
                                     const ros::Time& now) {
  const std::vector<Robot>& robots = world.robots().list();
  const double tick = world.tickDuration();
  const double count = std::max(1.0, std::round(tick * odometry_rate_));  // of times in a tick, its end included
  between_.clear();
  for (double i = 1.0; i < count; i += 1.0) {
    const ros::Time time = now - ros::Duration(tick * (count - i) / count);
    for (RobotId robot = 0; robot < robots.size(); ++robot) {
      const Pose& from = last_odometry_[robot].pose;
      const Twist twist = twistBetween(from, senses.odometry(robot).pose, tick);
      const Odometry odometry{drivePose(from, twist, tick * i / count), twist};
      if (robots[robot].start.drive == Drive::EXTERNAL) continue;
      topics[robot]->publishOdometry(odometry, senses.covariance(robot), time);
      topics[robot]->addTransforms(last_odom_[robot], odometry, time, between_);
    }
  }
  if (!between_.empty()) transforms_->sendTransform(between_);
}

void RobotTransforms::publishMounts(const Topics& topics, const ros::Time& now) {
  std::vector<geometry_msgs::TransformStamped> mounts;
  mounts.reserve(topics.size());
  for (const auto& of_robot : topics) mounts.push_back(of_robot->mountTransform(now));
  static_transforms_->sendTransform(mounts);
}

void RobotTransforms::remove(RobotId id) {
  last_odometry_.erase(last_odometry_.begin() + id);
  last_odom_.erase(last_odom_.begin() + id);
}

}  // namespace crowd
