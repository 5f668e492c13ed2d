#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <geometry_msgs/PoseArray.h>
#include <geometry_msgs/TransformStamped.h>
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>
#include <social_crowd/Neighbour.h>
#include <social_crowd/RobotObservation.h>
#include <social_crowd/RobotState.h>

#include <string>
#include <vector>

#include "robots/ring_scan.h"
#include "robots/robot_commands.h"
#include "robots/robot_observation.h"
#include "robots/robot_senses.h"
#include "ros/robots/pose_collector.h"
#include "world/world.h"

/// Conversions of robots and their sensors to messages. The caller sets headers, unless it says otherwise.
namespace crowd {

/// @brief What the names of the robot's frames begin with.
std::string framePrefix(const RobotStart& start);

/// Variances of what is not measured (height [m^2], roll and pitch [rad^2], and their rates), and the least of others,
/// as filters need positive ones.
constexpr double UNMEASURED = 1e6;
constexpr double LEAST_VARIANCE = 1e-6;
/// @brief Writes the covariance of a pose or twist in space. @param covariance of x, y and heading
void writeCovariance(const Eigen::Matrix3d& covariance, boost::array<double, 36>& numbers);

Twist fromMessage(const geometry_msgs::Twist& message);
/// @brief The pose of a frame in its parent; rotations other than about the vertical axis are left out.
Pose fromMessage(const geometry_msgs::Transform& message);
geometry_msgs::Twist toMessage(const Twist& twist);
geometry_msgs::Pose toMessage(const Pose& pose);

/// @brief The transform from the header's frame to `child`.
geometry_msgs::TransformStamped toTransform(const std_msgs::Header& header, const std::string& child, const Pose& pose);
/// @brief Pose of `to` in the frame of `from`, both given in one frame.
Pose relativePose(const Pose& from, const Pose& to);
/// @brief Pose in the frame that `frame` is given in of something at `pose` in `frame`.
Pose composedPose(const Pose& frame, const Pose& pose);

/// @brief Pose, twist and covariances.
nav_msgs::Odometry toMessage(const Odometry& odometry, const OdometryCovariance& covariance);
/// @brief Description and ranges of a scan; `ranges` may be empty. @param tick_duration [s]
sensor_msgs::LaserScan toMessage(const ScanSpec& spec, const std::vector<float>& ranges, double tick_duration);
/// @brief The points that rays hit, at height 0 of the sensor frame.
sensor_msgs::PointCloud2 toCloud(const ScanSpec& spec, const std::vector<float>& ranges);
/// @brief Points of several rings, with the fields x, y, z, intensity and ring.
sensor_msgs::PointCloud2 toCloud(const std::vector<ScanPoint>& points);
/// @brief Corners of the robot, in its base frame; of a disc, of a polygon around it.
geometry_msgs::Polygon toMessage(const Footprint& footprint);

/// @brief All fields but the counts of commands and poses.
social_crowd::RobotState toMessage(const Robot& robot, RobotId id);
void writeCounts(const CommandCounts& counts, social_crowd::RobotState& message);
void writeCounts(const PoseInput& input, social_crowd::RobotState& message);
social_crowd::Neighbour toMessage(const Neighbour& neighbour);
/// @brief All fields but header, scan, people and result.
social_crowd::RobotObservation toMessage(const RobotStart& start, const RobotObservation& seen);

}  // namespace crowd
