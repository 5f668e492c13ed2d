#include "ros/robots/robot_messages.h"

#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ros/messages/conversions.h"

namespace crowd {
namespace {

constexpr int DISC_CORNERS = 16;
constexpr std::size_t DIMENSIONS = 6;  // x, y, z, and rotations about these axes
constexpr std::array<std::size_t, 3> MEASURED = {0, 1, 5};

geometry_msgs::Pose2D toPose2D(const Pose& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.position.x();
  message.y = pose.position.y();
  message.theta = pose.heading;
  return message;
}

}  // namespace

void writeCovariance(const Eigen::Matrix3d& covariance, boost::array<double, DIMENSIONS * DIMENSIONS>& numbers) {
  numbers.fill(0.0);
  for (std::size_t i = 0; i < DIMENSIONS; ++i) numbers[i * DIMENSIONS + i] = UNMEASURED;
  for (std::size_t i = 0; i < MEASURED.size(); ++i) {
    for (std::size_t k = 0; k < MEASURED.size(); ++k) {
      const double value = covariance(static_cast<int>(i), static_cast<int>(k));
      numbers[MEASURED[i] * DIMENSIONS + MEASURED[k]] = i == k ? std::max(LEAST_VARIANCE, value) : value;
    }
  }
}

std::string framePrefix(const RobotStart& start) { return start.name_space.empty() ? "" : start.name_space + "/"; }

Twist fromMessage(const geometry_msgs::Twist& message) {
  return {{message.linear.x, message.linear.y}, message.angular.z};
}

Pose fromMessage(const geometry_msgs::Transform& message) {
  return {fromVector3(message.translation), tf2::getYaw(message.rotation)};
}

geometry_msgs::Twist toMessage(const Twist& twist) {
  geometry_msgs::Twist message;
  message.linear = toVector3(twist.linear);
  message.angular.z = twist.rotation;
  return message;
}

geometry_msgs::Pose toMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = toPoint(pose.position);
  message.orientation = toQuaternion(pose.heading);
  return message;
}

geometry_msgs::TransformStamped toTransform(const std_msgs::Header& header, const std::string& child,
                                            const Pose& pose) {
  geometry_msgs::TransformStamped transform;
  transform.header = header;
  transform.child_frame_id = child;
  transform.transform.translation = toVector3(pose.position);
  transform.transform.rotation = toQuaternion(pose.heading);
  return transform;
}

Pose relativePose(const Pose& from, const Pose& to) {
  return {Rotation(from.heading).intoFrame(to.position - from.position), wrapAngle(to.heading - from.heading)};
}

Pose composedPose(const Pose& frame, const Pose& pose) {
  return {frame.position + Rotation(frame.heading).outOfFrame(pose.position), wrapAngle(frame.heading + pose.heading)};
}

nav_msgs::Odometry toMessage(const Odometry& odometry, const OdometryCovariance& covariance) {
  nav_msgs::Odometry message;
  message.pose.pose = toMessage(odometry.pose);
  message.twist.twist = toMessage(odometry.twist);
  writeCovariance(covariance.pose, message.pose.covariance);
  writeCovariance(covariance.twist, message.twist.covariance);
  return message;
}

sensor_msgs::LaserScan toMessage(const ScanSpec& spec, const std::vector<float>& ranges, double tick_duration) {
  sensor_msgs::LaserScan message;
  const double increment = angleIncrement(spec);
  message.angle_min = static_cast<float>(spec.first_angle);
  message.angle_max = static_cast<float>(spec.first_angle + increment * (static_cast<double>(spec.rays) - 1.0));
  message.angle_increment = static_cast<float>(increment);
  message.scan_time = static_cast<float>(static_cast<double>(scanTicks(spec, tick_duration)) * tick_duration);
  message.range_min = static_cast<float>(spec.min_range);
  message.range_max = static_cast<float>(spec.max_range);
  message.ranges = ranges;
  return message;
}

sensor_msgs::PointCloud2 toCloud(const ScanSpec& spec, const std::vector<float>& ranges) {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  const auto is_hit = [](float range) { return std::isfinite(range); };
  modifier.resize(static_cast<std::size_t>(std::count_if(ranges.begin(), ranges.end(), is_hit)));
  sensor_msgs::PointCloud2Iterator<float> place(cloud, "x");  // y and z are behind it
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (!is_hit(ranges[i])) continue;
    const Vector2 point =
        static_cast<double>(ranges[i]) * unitVector(spec.first_angle + static_cast<double>(i) * angleIncrement(spec));
    place[0] = static_cast<float>(point.x());
    place[1] = static_cast<float>(point.y());
    place[2] = 0.0F;
    ++place;
  }
  cloud.is_dense = 1;
  return cloud;
}

sensor_msgs::PointCloud2 toCloud(const std::vector<ScanPoint>& points) {
  using sensor_msgs::PointField;
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2Fields(5, "x", 1, PointField::FLOAT32, "y", 1, PointField::FLOAT32, "z", 1,
                                PointField::FLOAT32, "intensity", 1, PointField::FLOAT32, "ring", 1,
                                PointField::UINT16);
  modifier.resize(points.size());
  sensor_msgs::PointCloud2Iterator<float> numbers(cloud, "x");  // y, z and intensity are behind it
  sensor_msgs::PointCloud2Iterator<std::uint16_t> ring(cloud, "ring");
  for (const ScanPoint& point : points) {
    numbers[0] = point.x;
    numbers[1] = point.y;
    numbers[2] = point.z;
    numbers[3] = point.intensity;
    *ring = point.ring;
    ++numbers;
    ++ring;
  }
  cloud.is_dense = 1;
  return cloud;
}

geometry_msgs::Polygon toMessage(const Footprint& footprint) {
  std::vector<Vector2> corners = footprint.corners;
  for (int i = 0; footprint.isDisc() && i < DISC_CORNERS; ++i) {
    corners.emplace_back(footprint.radius * unitVector(2.0 * PI * i / DISC_CORNERS));
  }
  geometry_msgs::Polygon polygon;
  for (const Vector2& corner : corners) {
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(corner.x());
    point.y = static_cast<float>(corner.y());
    polygon.points.push_back(point);
  }
  return polygon;
}

social_crowd::RobotState toMessage(const Robot& robot, RobotId id) {
  social_crowd::RobotState message;
  message.robot = id;
  message.name = robot.start.name;
  message.status = static_cast<std::uint8_t>(robot.status);
  message.pose = toPose2D(robot.pose);
  message.twist = toMessage(robot.twist);
  message.command = toMessage(robot.target);
  for (const Vector2& corner : robot.start.footprint.corners) message.footprint.push_back(toPoint(corner));
  message.radius = robot.start.footprint.reach();
  message.has_goal = robot.hasGoal() ? 1 : 0;
  if (robot.hasGoal()) message.goal = toPoint(robot.goal());
  message.blocked = robot.blocked ? 1 : 0;
  for (const RobotContact& contact : robot.contacts) message.contacts.push_back(contact.agent);
  return message;
}

void writeCounts(const CommandCounts& counts, social_crowd::RobotState& message) {
  const auto refused = [&](CommandRefusal cause) { return counts.refused[static_cast<std::size_t>(cause)]; };
  message.commands_taken = counts.taken;
  message.commands_missed = counts.missed;
  message.commands_late = counts.late;
  message.command_timeouts = counts.timeouts;
  message.commands_not_finite = refused(CommandRefusal::NOT_FINITE);
  message.commands_of_others = refused(CommandRefusal::OTHER_PUBLISHER);
  message.commands_repeated = counts.newer;
}

void writeCounts(const PoseInput& input, social_crowd::RobotState& message) {
  message.poses_taken = input.counts.taken;
  message.poses_not_finite = input.counts.not_finite;
  message.poses_backwards = input.counts.backwards;
  message.poses_without_frame = input.without_frame;
  message.pose_jumps = input.counts.jumps;
  message.pose_gaps = input.counts.gaps;
  message.pose_stale = input.counts.stale;
}

social_crowd::Neighbour toMessage(const Neighbour& neighbour) {
  social_crowd::Neighbour message;
  message.kind = static_cast<std::uint8_t>(neighbour.kind);
  message.x = neighbour.position.x();
  message.y = neighbour.position.y();
  message.velocity_x = neighbour.velocity.x();
  message.velocity_y = neighbour.velocity.y();
  message.radius = neighbour.radius;
  return message;
}

social_crowd::RobotObservation toMessage(const RobotStart& start, const RobotObservation& seen) {
  social_crowd::RobotObservation message;
  message.name = start.name;
  message.drive = DRIVES.nameOf(start.drive);
  message.max_speed = start.limits.max_speed;
  message.max_rotation = start.limits.max_rotation;
  message.radius = start.footprint.reach();
  message.pose = toPose2D(seen.pose);
  message.twist = toMessage(seen.twist);
  message.has_goal = seen.has_goal ? 1 : 0;
  message.arrived = seen.arrived ? 1 : 0;
  if (seen.has_goal) message.goal = toPoint(seen.goal);
  message.remaining_distance = seen.remaining_distance;
  message.blocked = seen.blocked ? 1 : 0;
  message.contacts = seen.contacts;
  message.contacts_by_robot = seen.by_robot;
  message.contacts_by_person = seen.by_person;
  message.clearance = seen.clearance;
  return message;
}

}  // namespace crowd
