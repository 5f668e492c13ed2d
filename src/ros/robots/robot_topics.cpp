#include "ros/robots/robot_topics.h"

#include <geometry_msgs/PoseStamped.h>

#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/publish_latched.h"

namespace crowd {

RobotTopics::RobotTopics(const ros::NodeHandle& node, const RobotStart& start, RobotId id)
    : own_(node, start.name_space), id_(id), start_(start), prefix_(framePrefix(start)) {
  own_.setCallbackQueue(node.getCallbackQueue());
  if (start.drive != Drive::EXTERNAL) odometry_ = own_.advertise<nav_msgs::Odometry>(names::ODOMETRY, QUEUE);
  scan_topics_.advertise(own_, names::SCAN, [this](const Tick& tick) {
    return scanMessage(tick.senses.ranges(tick.world, id_), tick.world.tickDuration(), tick.now);
  });
  scan_topics_.advertise(own_, "scan_cloud", [this](const Tick& tick) {
    return stamped(toCloud(start_.scan, tick.senses.ranges(tick.world, id_)), names::LASER_FRAME, tick.now);
  });
  if (start.scan.rings > 0) {
    scan_topics_.advertise(own_, "points", [this](const Tick& tick) {
      return stamped(toCloud(tick.senses.points(tick.world, id_)), names::LASER_FRAME, tick.now);
    });
  }
  people_ = peopleTopics(own_);
  tick_topics_.advertise(own_, "footprint", [this](const Tick& tick) {
    geometry_msgs::PolygonStamped footprint;
    footprint.polygon = toMessage(start_.footprint);
    return stamped(footprint, names::BASE_FRAME, tick.now);
  });
  goals_ = own_.advertise<geometry_msgs::PoseStamped>(names::GOAL, QUEUE, LATCHED);
}

std_msgs::Header RobotTopics::header(const std::string& frame, const ros::Time& now) const {
  std_msgs::Header header;
  header.frame_id = frame == names::MAP_FRAME ? frame : prefix_ + frame;
  header.stamp = now;
  return header;
}

void RobotTopics::publish(const World& world, RobotSenses& senses, const ros::Time& now) {
  const Tick tick{world, senses, now};
  publishOdometry(senses.odometry(id_), senses.covariance(id_), now);
  if (world.tick() % scanTicks(start_.scan, world.tickDuration()) == 0) scan_topics_.publish(tick);
  publishPeople(tick);
  tick_topics_.publish(tick);
}

void RobotTopics::publishOdometry(const Odometry& odometry, const OdometryCovariance& covariance,
                                  const ros::Time& time) {
  if (odometry_.getNumSubscribers() == 0) return;
  nav_msgs::Odometry message = stamped(toMessage(odometry, covariance), names::ODOM_FRAME, time);
  message.child_frame_id = prefix_ + names::BASE_FRAME;
  odometry_.publish(message);
}

sensor_msgs::LaserScan RobotTopics::scanMessage(const std::vector<float>& ranges, double tick_duration,
                                                const ros::Time& now) const {
  return stamped(toMessage(start_.scan, ranges, tick_duration), names::LASER_FRAME, now);
}

void RobotTopics::publishPeople(const Tick& tick) {
  if (!start_.tracks.keep && !people_.haveSubscribers()) return;
  people_.publish(tick.senses.tracks(tick.world, id_), header(names::MAP_FRAME, tick.now));
}

void RobotTopics::publishGoal(const Robot& robot, const ros::Time& now, bool begins) {
  const std::optional<Vector2> goal = robot.hasGoal() ? std::optional(robot.goal()) : std::nullopt;
  if (!begins && goal == goal_) return;
  goal_ = goal;
  if (!goal) return;
  geometry_msgs::PoseStamped message;
  message.pose = toMessage(Pose{*goal, bearingOf(*goal - robot.pose.position)});
  publishLatched(goals_, stamped(message, names::MAP_FRAME, now));
}

void RobotTopics::addTransforms(const std::optional<Pose>& odom_in_map, const Odometry& odometry, const ros::Time& time,
                                std::vector<geometry_msgs::TransformStamped>& transforms) const {
  if (start_.drive == Drive::EXTERNAL) return;
  if (odom_in_map) {
    transforms.push_back(toTransform(header(names::MAP_FRAME, time), prefix_ + names::ODOM_FRAME, *odom_in_map));
  }
  transforms.push_back(toTransform(header(names::ODOM_FRAME, time), prefix_ + names::BASE_FRAME, odometry.pose));
}

geometry_msgs::TransformStamped RobotTopics::mountTransform(const ros::Time& now) const {
  geometry_msgs::TransformStamped mount =
      toTransform(header(names::BASE_FRAME, now), prefix_ + names::LASER_FRAME, start_.scan.mount);
  mount.transform.translation.z = start_.scan.height;
  return mount;
}

}  // namespace crowd
