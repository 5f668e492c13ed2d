#include "ros/robots/robot_controller_node.h"

#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include "common/text/quotes.h"
#include "robots/controllers/reactive_rule.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"
#include "ros/node/parameters.h"
#include "ros/robots/robot_messages.h"

namespace crowd {
namespace {

constexpr std::uint32_t NEWEST = 1;         // message: older scans are not worth a command
constexpr double SCAN_WARNING_PERIOD = 10;  // [s]
const ros::WallDuration TF_PATIENCE(0.2);
const ros::WallDuration FIRST_TF_PATIENCE(0.02);  // ticks do not wait for a first answer, so it must be in time
const ros::WallDuration TF_CHECK(0.0002);

/// The range of lengths, speeds and accelerations.
constexpr NumberRange rangeIn(const char* unit) { return {1e-3, 1e3, unit}; }

/// The scanner that a message describes, mounted at a pose of the robot's frame.
ScanSpec scannerOf(const sensor_msgs::LaserScan& message, const Pose& mount) {
  ScanSpec scanner;
  scanner.rays = static_cast<std::uint32_t>(message.ranges.size());
  scanner.first_angle = static_cast<double>(message.angle_min);
  scanner.last_angle = static_cast<double>(message.angle_max);
  scanner.min_range = static_cast<double>(message.range_min);
  scanner.max_range = static_cast<double>(message.range_max);
  scanner.mount = mount;
  return scanner;
}

Drive readDrive(Parameters& parameters) {
  const std::string name =
      parameters.text("drive", DRIVES.nameOf(Drive::DIFFERENTIAL), "differential, holonomic or ackermann");
  for (const Drive drive : {Drive::DIFFERENTIAL, Drive::HOLONOMIC, Drive::ACKERMANN}) {
    if (DRIVES.nameOf(drive) == name) return drive;
  }
  parameters.complain("drive", "expected differential, holonomic or ackermann, got " + inQuotes(name));
  return Drive::DIFFERENTIAL;
}

}  // namespace

RobotControllerParameters readRobotControllerParameters(const ros::NodeHandle& private_node) {
  Parameters parameters(private_node);
  RobotControllerParameters read;
  RobotStart& robot = read.robot;
  robot.drive = readDrive(parameters);
  robot.footprint.radius = parameters.number("radius", 0.3, rangeIn("m"));
  robot.limits.max_speed = parameters.number("max_speed", 1.0, rangeIn("m/s"));
  robot.limits.max_rotation = parameters.number("max_rotation", robot.limits.max_rotation, rangeIn("rad/s"));
  robot.limits.max_acceleration = parameters.number("acceleration", robot.limits.max_acceleration, rangeIn("m/s^2"));
  read.goal_tolerance = parameters.number("goal_tolerance", read.goal_tolerance, rangeIn("m"));
  read.base_frame = parameters.text("base_frame", read.base_frame);
  read.map_frame = parameters.text("map_frame", read.map_frame);
  parameters.finish();
  return read;
}

RobotControllerNode::RobotControllerNode(const ros::NodeHandle& node, const ros::NodeHandle& private_node)
    : parameters_(readRobotControllerParameters(private_node)), node_(loop_.adopt(node)), listener_(frames_) {
  commands_ = node_.advertise<geometry_msgs::Twist>(names::CMD_VEL, SHORT_QUEUE);
  goals_ =
      node_.subscribe<geometry_msgs::PoseStamped>(names::GOAL, SHORT_QUEUE, [this](const auto& goal) { goal_ = goal; });
  const boost::function<void(const sensor_msgs::LaserScan::ConstPtr&)> take = [this](const auto& scan) {
    takeScan(*scan);
  };
  scans_ = node_.subscribe<sensor_msgs::LaserScan>(names::SCAN, NEWEST, take, ros::VoidConstPtr(),
                                                   ros::TransportHints().tcpNoDelay());
}

void RobotControllerNode::run() {
  while (!loop_.isClosed()) loop_.run(IDLE);
}

void RobotControllerNode::takeScan(const sensor_msgs::LaserScan& scan) {
  try {
    if (awaitTransform(scan)) {
      commands_.publish(toMessage(commandFor(scan)));
      has_answered_ = true;
    } else if (has_answered_) {  // else tf begins later than the scans
      ROS_WARN_THROTTLE(SCAN_WARNING_PERIOD, "a scan is not answered: tf does not lead from '%s' to '%s' at its time",
                        parameters_.map_frame.c_str(), scan.header.frame_id.c_str());
    }
  } catch (const tf2::TransformException& error) {
    ROS_WARN_THROTTLE(SCAN_WARNING_PERIOD, "the robot stands: %s", error.what());
    commands_.publish(geometry_msgs::Twist());
  }
}

bool RobotControllerNode::awaitTransform(const sensor_msgs::LaserScan& scan) const {
  const auto is_known = [&] {
    return frames_.canTransform(parameters_.map_frame, scan.header.frame_id, scan.header.stamp);
  };
  const ros::WallTime end = ros::WallTime::now() + (has_answered_ ? TF_PATIENCE : FIRST_TF_PATIENCE);
  while (!is_known() && ros::WallTime::now() < end) TF_CHECK.sleep();
  return is_known();
}

Twist RobotControllerNode::commandFor(const sensor_msgs::LaserScan& scan) {
  if (goal_ == nullptr) return {};
  const ros::Time& time = scan.header.stamp;
  const std::string& base = parameters_.base_frame;
  geometry_msgs::Point goal;
  tf2::doTransform(goal_->pose.position, goal, frames_.lookupTransform(base, goal_->header.frame_id, time));
  const Vector2 offset = fromPoint(goal);
  if (offset.norm() < parameters_.goal_tolerance) return {};
  RobotStart robot = parameters_.robot;
  robot.scan = scannerOf(scan, fromMessage(frames_.lookupTransform(base, scan.header.frame_id, time).transform));
  return reactiveCommand(robot, offset, scan.ranges);
}

}  // namespace crowd
