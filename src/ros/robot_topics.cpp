#include "social_crowd/ros/robot_topics.h"

#include <utility>

#include "social_crowd/ros/conversions.h"
#include "social_crowd/ros/names.h"

namespace crowd {
namespace {

constexpr std::uint32_t QUEUE = 100;  // messages
constexpr bool LATCHED = true;

}  // namespace

RobotTopics::RobotTopics(const ros::NodeHandle& node, const RobotStart& start, RobotId id, Handlers handlers)
    : id_(id), start_(start), prefix_(start.name_space.empty() ? "" : start.name_space + "/") {
  ros::NodeHandle own(node, start.name_space);
  own.setCallbackQueue(node.getCallbackQueue());
  const bool is_external = start.drive == Drive::EXTERNAL;
  if (is_external)
    ROS_WARN("robot '%s': poses of external robots are not received yet; it stays where it is", start.name.c_str());
  if (!is_external) odometry_ = own.advertise<nav_msgs::Odometry>(names::ODOMETRY, QUEUE);
  scan_ = own.advertise<sensor_msgs::LaserScan>(names::SCAN, QUEUE);
  cloud_ = own.advertise<sensor_msgs::PointCloud2>(names::SCAN_CLOUD, QUEUE);
  people_ = own.advertise<geometry_msgs::PoseArray>(names::PEOPLE_POSES, QUEUE);
  footprint_ = own.advertise<geometry_msgs::PolygonStamped>(names::FOOTPRINT, QUEUE);
  goals_ = own.advertise<geometry_msgs::PoseStamped>(names::GOAL, QUEUE, LATCHED);
  const boost::function<void(const ros::MessageEvent<const geometry_msgs::Twist>&)> take =
      [command = std::move(handlers.command)](const ros::MessageEvent<const geometry_msgs::Twist>& event) {
        command(fromMessage(*event.getMessage()), event.getPublisherName());
      };
  if (!is_external)
    commands_ = own.subscribe<geometry_msgs::Twist>(names::CMD_VEL, QUEUE, take, ros::VoidConstPtr(),
                                                    ros::TransportHints().tcpNoDelay());
  const boost::function<void(const geometry_msgs::PoseStamped::ConstPtr&)> set =
      [goal = std::move(handlers.goal)](const geometry_msgs::PoseStamped::ConstPtr& message) { goal(*message); };
  new_goals_ = own.subscribe<geometry_msgs::PoseStamped>(names::NEW_GOAL, QUEUE, set);
}

std_msgs::Header RobotTopics::header(const std::string& frame, const ros::Time& now) const {
  std_msgs::Header header;
  header.frame_id = frame == names::MAP_FRAME ? frame : prefix_ + frame;
  header.stamp = now;
  return header;
}

void RobotTopics::publish(const World& world, RobotSenses& senses, const ros::Time& now) {
  if (odometry_.getNumSubscribers() > 0) {
    nav_msgs::Odometry odometry = toMessage(senses.odometry(id_));
    odometry.header = header(names::ODOM_FRAME, now);
    odometry.child_frame_id = prefix_ + names::BASE_FRAME;
    odometry_.publish(odometry);
  }
  publishScan(world, senses, now);
  publishPeople(world, now);
  if (footprint_.getNumSubscribers() > 0) {
    geometry_msgs::PolygonStamped footprint;
    footprint.header = header(names::BASE_FRAME, now);
    footprint.polygon = toMessage(start_.footprint);
    footprint_.publish(footprint);
  }
}

void RobotTopics::publishScan(const World& world, RobotSenses& senses, const ros::Time& now) {
  // Half a tick of tolerance, against rounding of the clock.
  const ros::Duration due(start_.scan.period - 0.5 * world.tickDuration());
  if (!scanned_at_.isZero() && now >= scanned_at_ && now - scanned_at_ < due) return;
  scanned_at_ = now;
  if (scan_.getNumSubscribers() > 0) {
    scan_.publish(scanMessage(senses.ranges(world, id_), world.tickDuration(), now));
  }
  if (cloud_.getNumSubscribers() > 0) {
    sensor_msgs::PointCloud2 cloud = toCloud(start_.scan, senses.ranges(world, id_));
    cloud.header = header(names::LASER_FRAME, now);
    cloud_.publish(cloud);
  }
}

sensor_msgs::LaserScan RobotTopics::scanMessage(const std::vector<float>& ranges, double tick_duration,
                                                const ros::Time& now) const {
  sensor_msgs::LaserScan scan = toMessage(start_.scan, ranges, tick_duration);
  scan.header = header(names::LASER_FRAME, now);
  return scan;
}

void RobotTopics::publishPeople(const World& world, const ros::Time& now) {
  if (people_.getNumSubscribers() == 0) return;
  geometry_msgs::PoseArray people;
  people.header = header(names::MAP_FRAME, now);
  for (const Agent& agent : world.agents()) {
    if (agent.isWalking()) people.poses.push_back(toMessage(agent.pose));
  }
  people_.publish(people);
}

void RobotTopics::publishGoal(const Robot& robot, const ros::Time& now, bool begins) {
  const std::optional<Vector2> goal = robot.hasGoal() ? std::optional(robot.goal()) : std::nullopt;
  if (!begins && goal == goal_) return;
  goal_ = goal;
  if (!goal) return;
  geometry_msgs::PoseStamped message;
  message.header = header(names::MAP_FRAME, now);
  message.pose = toMessage(Pose{*goal, bearingOf(*goal - robot.pose.position)});
  goals_.publish(message);
}

void RobotTopics::addTransforms(const Robot& robot, const Odometry& odometry, const ros::Time& now, bool localised,
                                std::vector<geometry_msgs::TransformStamped>& transforms) const {
  if (start_.drive == Drive::EXTERNAL) return;
  if (localised) {
    transforms.push_back(toTransform(header(names::MAP_FRAME, now), prefix_ + names::ODOM_FRAME,
                                     composedPose(robot.pose, relativePose(odometry.pose, Pose()))));
  }
  transforms.push_back(toTransform(header(names::ODOM_FRAME, now), prefix_ + names::BASE_FRAME, odometry.pose));
}

geometry_msgs::TransformStamped RobotTopics::mountTransform(const ros::Time& now) const {
  return toTransform(header(names::BASE_FRAME, now), prefix_ + names::LASER_FRAME, start_.scan.mount);
}

}  // namespace crowd
