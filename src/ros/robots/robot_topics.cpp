#include "ros/robots/robot_topics.h"

#include <std_msgs/String.h>

#include <utility>

#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/publish_latched.h"
#include "ros/messages/topic_defaults.h"

namespace crowd {

RobotTopics::RobotTopics(const ros::NodeHandle& node, const RobotStart& start, RobotId id, Handlers handlers)
    : id_(id), start_(start), prefix_(framePrefix(start)) {
  ros::NodeHandle own(node, start.name_space);
  own.setCallbackQueue(node.getCallbackQueue());
  const bool is_external = start.drive == Drive::EXTERNAL;
  if (!is_external) odometry_ = own.advertise<nav_msgs::Odometry>(names::ODOMETRY, QUEUE);
  scan_ = own.advertise<sensor_msgs::LaserScan>(names::SCAN, QUEUE);
  cloud_ = own.advertise<sensor_msgs::PointCloud2>(names::SCAN_CLOUD, QUEUE);
  if (start.scan.rings > 0) points_ = own.advertise<sensor_msgs::PointCloud2>(names::POINTS, QUEUE);
  people_.emplace(own);
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
  const boost::function<void(const std_msgs::String::ConstPtr&)> note =
      [navigation = std::move(handlers.navigation)](const std_msgs::String::ConstPtr& state) {
        navigation(state->data);
      };
  const boost::function<void(const geometry_msgs::PoseWithCovarianceStamped::ConstPtr&)> place =
      [pose = std::move(handlers.pose)](const auto& message) { pose(*message); };
  new_poses_ = own.subscribe<geometry_msgs::PoseWithCovarianceStamped>(names::NEW_POSE, QUEUE, place);
  navigation_ = own.subscribe<std_msgs::String>(names::NAVIGATION, QUEUE, note);
}

std_msgs::Header RobotTopics::header(const std::string& frame, const ros::Time& now) const {
  std_msgs::Header header;
  header.frame_id = frame == names::MAP_FRAME ? frame : prefix_ + frame;
  header.stamp = now;
  return header;
}

void RobotTopics::publish(const World& world, RobotSenses& senses, const ros::Time& now) {
  publishOdometry(senses.odometry(id_), senses.covariance(id_), now);
  publishScan(world, senses, now);
  publishPeople(world, senses, now);
  if (footprint_.getNumSubscribers() > 0) {
    geometry_msgs::PolygonStamped footprint;
    footprint.header = header(names::BASE_FRAME, now);
    footprint.polygon = toMessage(start_.footprint);
    footprint_.publish(footprint);
  }
}

void RobotTopics::publishOdometry(const Odometry& odometry, const OdometryCovariance& covariance,
                                  const ros::Time& time) {
  if (odometry_.getNumSubscribers() == 0) return;
  nav_msgs::Odometry message = toMessage(odometry, covariance);
  message.header = header(names::ODOM_FRAME, time);
  message.child_frame_id = prefix_ + names::BASE_FRAME;
  odometry_.publish(message);
}

void RobotTopics::publishScan(const World& world, RobotSenses& senses, const ros::Time& now) {
  if (world.tick() % scanTicks(start_.scan, world.tickDuration()) != 0) return;
  if (scan_.getNumSubscribers() > 0) {
    scan_.publish(scanMessage(senses.ranges(world, id_), world.tickDuration(), now));
  }
  if (cloud_.getNumSubscribers() > 0) {
    sensor_msgs::PointCloud2 cloud = toCloud(start_.scan, senses.ranges(world, id_));
    cloud.header = header(names::LASER_FRAME, now);
    cloud_.publish(cloud);
  }
  if (points_ && points_.getNumSubscribers() > 0) {
    sensor_msgs::PointCloud2 points = toCloud(senses.points(world, id_));
    points.header = header(names::LASER_FRAME, now);
    points_.publish(points);
  }
}

sensor_msgs::LaserScan RobotTopics::scanMessage(const std::vector<float>& ranges, double tick_duration,
                                                const ros::Time& now) const {
  sensor_msgs::LaserScan scan = toMessage(start_.scan, ranges, tick_duration);
  scan.header = header(names::LASER_FRAME, now);
  return scan;
}

void RobotTopics::publishPeople(const World& world, RobotSenses& senses, const ros::Time& now) {
  if (!start_.tracks.keep && !people_->haveSubscribers()) return;
  people_->publish(senses.tracks(world, id_), header(names::MAP_FRAME, now));
}

void RobotTopics::publishGoal(const Robot& robot, const ros::Time& now, bool begins) {
  const std::optional<Vector2> goal = robot.hasGoal() ? std::optional(robot.goal()) : std::nullopt;
  if (!begins && goal == goal_) return;
  goal_ = goal;
  if (!goal) return;
  geometry_msgs::PoseStamped message;
  message.header = header(names::MAP_FRAME, now);
  message.pose = toMessage(Pose{*goal, bearingOf(*goal - robot.pose.position)});
  publishLatched(goals_, message);
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
