#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <sensor_msgs/LaserScan.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include <string>

#include "ros/node/main_loop.h"
#include "scenario/robot.h"

namespace crowd {

/// @brief Parameters of the node robot_controller.
struct RobotControllerParameters {
  RobotStart robot;                      ///< ~drive, ~radius, ~max_speed, ~max_rotation, ~acceleration
  double goal_tolerance = 0.1;           ///< ~goal_tolerance: it stops within this distance of its goal [m]
  std::string base_frame = "base_link";  ///< ~base_frame: frame of the robot
  std::string map_frame = "map";         ///< ~map_frame: fixed frame, from which tf leads to the robot
};

/// @throws InputError that lists all invalid parameters
RobotControllerParameters readRobotControllerParameters(const ros::NodeHandle& private_node);

/// @brief Node that drives one robot by its laser scan and its goal alone (reactiveCommand()): an example to be
/// replaced by one's own controller.
///
/// It answers each message on `scan` with one on `cmd_vel`, when tf has the robot's pose at the time of the scan: the
/// same scans, poses and goals give the same commands. A scan without such a pose is not answered. Without a goal, and
/// at the goal, the command is to stand.
class RobotControllerNode {
 public:
  /// @throws InputError that lists invalid parameters
  RobotControllerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node);

  /// @brief Drives until ROS shuts down.
  void run();

 private:
  void takeScan(const sensor_msgs::LaserScan& scan);
  /// Waits for the transform of a scan, which may arrive a little later than the scan; its listener has its own thread.
  /// The timeout of tf2_ros::Buffer is in simulated time, which stands still while the tick waits for the command.
  /// Returns whether it has arrived.
  bool awaitTransform(const sensor_msgs::LaserScan& scan) const;
  Twist commandFor(const sensor_msgs::LaserScan& scan);

  const RobotControllerParameters parameters_;
  MainLoop loop_;
  ros::NodeHandle node_;
  tf2_ros::Buffer frames_;
  tf2_ros::TransformListener listener_;
  ros::Publisher commands_;
  ros::Subscriber scans_;
  ros::Subscriber goals_;
  geometry_msgs::PoseStamped::ConstPtr goal_;  // null: none
  bool has_answered_ = false;
};

}  // namespace crowd
