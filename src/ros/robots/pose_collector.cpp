#include "ros/robots/pose_collector.h"

#include <tf2/exceptions.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/text/numbers.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"
#include "ros/robots/robot_messages.h"

namespace crowd {
namespace {

constexpr double NORM_TOLERANCE = 0.01;  // of the quaternion of a pose
const ros::Time LATEST;                  // tf: the newest transform
constexpr const char* ONCE = "Further ones are only counted, on ";

/// The heading is NaN unless the quaternion has length 1.
Pose poseOf(const geometry_msgs::Pose& message) {
  const geometry_msgs::Quaternion& q = message.orientation;
  const bool is_rotation = std::abs(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w - 1.0) < NORM_TOLERANCE;
  return {fromPoint(message.position), is_rotation ? tf2::getYaw(q) : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace

void PoseCollector::subscribe(const Episode& episode) {
  sources_.clear();
  warned_.clear();
  const std::vector<Robot>& robots = episode.world().robots().list();
  for (RobotId id = 0; id < robots.size(); ++id) {
    const RobotStart& start = robots[id].start;
    if (start.drive != Drive::EXTERNAL) continue;
    Source& source = *sources_.emplace_back(std::make_unique<Source>());
    source.id = id;
    source.name = start.name;
    if (start.reads_tf) {
      source.base = framePrefix(start) + names::BASE_FRAME;
      source.origin = std::string("tf, ") + names::MAP_FRAME + " -> " + source.base;
      continue;
    }
    const boost::function<void(const nav_msgs::Odometry::ConstPtr&)> take =
        [this, &source](const nav_msgs::Odometry::ConstPtr& message) { this->take(source, *message); };
    ros::NodeHandle own(node_, start.name_space);
    own.setCallbackQueue(node_.getCallbackQueue());
    source.odometry = own.subscribe<nav_msgs::Odometry>(names::ODOMETRY, QUEUE, take, ros::VoidConstPtr(),
                                                        ros::TransportHints().tcpNoDelay());
    source.origin = source.odometry.getTopic();
  }
  if (sources_.empty()) {
    listener_.reset();
  } else if (!listener_) {
    listener_ = std::make_unique<tf2_ros::TransformListener>(frames_, node_, false);
  }
}

void PoseCollector::begin(Episode& episode) {
  episode_ = &episode;
  for (const auto& source : sources_) {
    const RobotStart& start = episode.world().robots()[source->id].start;
    source->robot.begin(start.limits.max_speed, episode.scene().tick_duration);
    source->without_frame = 0;
  }
}

void PoseCollector::take(Source& source, const nav_msgs::Odometry& message) {
  const std::optional<Pose> pose = toMap(source, message.header.frame_id, poseOf(message.pose.pose));
  if (pose) take(source, *pose, message.header.stamp);
}

std::optional<Pose> PoseCollector::toMap(Source& source, const std::string& frame, const Pose& pose) {
  if (frame.empty() || frame == names::MAP_FRAME) return pose;
  try {
    const auto transform = frames_.lookupTransform(names::MAP_FRAME, frame, LATEST);
    return composedPose(fromMessage(transform.transform), pose);
  } catch (const tf2::TransformException& error) {
    ++source.without_frame;
    warn(source, Problem::WITHOUT_FRAME,
         "is refused: there is no transform from its frame '" + frame + "' to map (" + error.what() + ")");
    return std::nullopt;
  }
}

void PoseCollector::takeTransform(Source& source) {
  try {
    const auto transform = frames_.lookupTransform(names::MAP_FRAME, source.base, LATEST);
    take(source, fromMessage(transform.transform), transform.header.stamp);
  } catch (const tf2::TransformException&) {
    // Not there yet: the robot is stale after a while.
  }
}

void PoseCollector::take(Source& source, const Pose& pose, const ros::Time& measured) {
  const ros::Time stamp = measured.isZero() ? clock_() : measured;  // static transforms have none
  const std::optional<double> last = source.robot.stamp();
  const std::optional<PoseProblem> problem = source.robot.take(pose, stamp.toSec());
  if (!problem) return;
  const double gap = stamp.toSec() - last.value_or(0.0);
  const std::string seconds = toFixedText(std::abs(gap), 2) + " s";
  switch (*problem) {
    case PoseProblem::NOT_FINITE:
      return warn(source, Problem::NOT_FINITE,
                  "is refused: expected finite numbers, a place within 1e6 m, and a quaternion of length 1");
    case PoseProblem::BACKWARDS:
      return warn(source, Problem::BACKWARDS, "is refused: its stamp is " + seconds + " before that of the last one");
    case PoseProblem::JUMP:
      return warn(source, Problem::JUMP,
                  "is a jump: it is too far from the last one, " + seconds +
                      " earlier, for the maximum speed. It is "
                      "used, without a motion between them");
    case PoseProblem::GAP:
      return warn(source, Problem::GAP, "comes " + seconds + " after the last one: the speed in between is not known");
  }
}

void PoseCollector::place(const ros::Time& now) {
  for (const auto& source : sources_) {
    if (!source->base.empty()) takeTransform(*source);
    const std::optional<ExternalRobot::State> state = source->robot.at(now.toSec());
    if (state) episode_->robots().place(source->id, state->pose, state->velocity, state->jumped);
    if (source->robot.isStale()) warnOfStaleness(*source, now);
  }
}

std::optional<PoseInput> PoseCollector::inputOf(RobotId robot) const {
  for (const auto& source : sources_) {
    if (source->id == robot) return PoseInput{source->robot.counts(), source->without_frame};
  }
  return std::nullopt;
}

void PoseCollector::warn(const Source& source, Problem problem, const std::string& text) {
  if (!warned_.insert({source.id, problem}).second) return;
  ROS_WARN("robot '%s': a pose from %s %s. %s%s", source.name.c_str(), source.origin.c_str(), text.c_str(), ONCE,
           names::ROBOTS);
}

void PoseCollector::warnOfStaleness(const Source& source, const ros::Time& now) {
  if (!warned_.insert({source.id, Problem::STALE}).second) return;
  const std::optional<double> stamp = source.robot.stamp();
  const double age = now.toSec() - stamp.value_or(0.0);
  std::string text = "there is no pose yet";
  if (stamp && age > 0.0) text = "the last pose is " + toFixedText(age, 2) + " s old";
  if (stamp && age < 0.0) {
    text = "the last pose is stamped " + toFixedText(-age, 2) + " s later than the tick: do both use the same clock?";
  }
  ROS_WARN("robot '%s' stands still until poses from %s arrive: %s. %s%s", source.name.c_str(), source.origin.c_str(),
           text.c_str(), ONCE, names::ROBOTS);
}

}  // namespace crowd
