#include "ros/robots/robot_interface.h"

#include <algorithm>
#include <utility>

#include "common/text/numbers.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"

namespace crowd {
namespace {

std::vector<std::string> identitiesOf(const std::vector<Robot>& robots) {
  std::vector<std::string> identities;
  identities.reserve(robots.size());
  for (const Robot& robot : robots) {
    const RobotStart& start = robot.start;
    const std::string poses = start.drive == Drive::EXTERNAL ? (start.reads_tf ? " tf" : " odom") : "";
    identities.push_back(start.name + " " + start.name_space + poses);
  }
  return identities;
}

}  // namespace

RobotInterface::RobotInterface(MainLoop& loop, const ros::NodeHandle& node, const ControllerParameters& parameters,
                               std::function<ros::Time()> clock)
    : node_(node),
      clock_(clock),
      publish_localisation_(parameters.publish_localisation),
      visible_people_only_(parameters.visible_people_only),
      commands_(loop, parameters),
      poses_(node, std::move(clock)) {}

void RobotInterface::begin(Episode& episode) {
  episode_ = &episode;
  senses_ = std::make_unique<RobotSenses>(episode.scene());
  contacts_.clear();
  scanned_changes_ = episode.changes();
  commands_.begin(episode);
  if (identitiesOf(robots()) != advertised_) advertise();
  poses_.begin(episode);
  for (RobotId id = 0; id < robots().size(); ++id) topics_[id]->begin(robots()[id].start);
}

void RobotInterface::advertise() {
  advertised_ = identitiesOf(robots());
  topics_.clear();
  commands_.forgetWarnings();
  poses_.subscribe(*episode_);
  for (RobotId id = 0; id < robots().size(); ++id) {
    RobotTopics::Handlers handlers;
    handlers.command = [this, id](const Twist& command, const std::string& node) { commands_.take(id, command, node); };
    handlers.goal = [this, id](const geometry_msgs::PoseStamped& goal) { takeGoal(id, goal); };
    topics_.push_back(
        std::make_unique<RobotTopics>(node_, robots()[id].start, id, visible_people_only_, std::move(handlers)));
  }
  if (robots().empty() || transforms_) return;
  transforms_.emplace();
  static_transforms_.emplace();
  states_ = node_.advertise<social_crowd::RobotStates>(names::ROBOTS, QUEUE,
                                                       [this](const ros::SingleSubscriberPublisher& subscriber) {
                                                         if (!robots().empty()) subscriber.publish(states(clock_()));
                                                       });
}

void RobotInterface::takeGoal(RobotId robot, const geometry_msgs::PoseStamped& goal) {
  const std::string& name = robots()[robot].start.name;
  const std::string& frame = goal.header.frame_id;
  const Vector2 place = fromPoint(goal.pose.position);
  if (frame != names::MAP_FRAME && !frame.empty()) {
    ROS_WARN("robot '%s': a goal is refused: expected the frame map, got %s", name.c_str(), frame.c_str());
  } else if (!place.allFinite()) {
    ROS_WARN("robot '%s': a goal is refused: expected finite numbers, got %s", name.c_str(),
             (toText(place.x()) + ", " + toText(place.y())).c_str());
  } else {
    episode_->robots().setGoals(robot, {place});
    topics_[robot]->publishGoal(robots()[robot], clock_(), true);
  }
}

bool RobotInterface::wait(const std::function<ros::Time()>& end) {
  if (robots().empty()) return true;
  if (!commands_.wait()) return false;
  poses_.place(end());
  return true;
}

RobotInput RobotInterface::inputOf(RobotId robot) const {
  RobotInput input;
  const CommandCounts& commands = commands_.countsOf(robot);
  input.commands_taken = commands.taken;
  input.commands_missed = commands.missed;
  input.commands_late = commands.late;
  input.command_timeouts = commands.timeouts;
  for (const std::uint64_t refused : commands.refused) input.commands_refused += refused;
  if (const std::optional<PoseInput> poses = poses_.inputOf(robot)) {
    input.poses_taken = poses->counts.taken;
    input.poses_refused = poses->counts.not_finite + poses->counts.backwards + poses->without_frame;
    input.pose_jumps = poses->counts.jumps;
    input.pose_gaps = poses->counts.gaps;
    input.pose_stale = poses->counts.stale;
  }
  return input;
}

void RobotInterface::writeInput(std::vector<RobotResult>& results) const {
  for (RobotId robot = 0; robot < results.size(); ++robot) results[robot].input = inputOf(robot);
}

void RobotInterface::observe() {
  senses_->observe(episode_->world());
  scanned_changes_ = episode_->changes();
  for (std::size_t robot = 0; robot < contacts_.size(); ++robot) addContacts(robots()[robot], contacts_[robot]);
}

void RobotInterface::beginSteps(const CommandCollector::Commands& commands) {
  commands_.hold(commands);
  contacts_.assign(robots().size(), {});
}

void RobotInterface::endSteps() {
  commands_.release();
  contacts_.clear();
}

void RobotInterface::publish(const ros::Time& now, bool begins) {
  if (robots().empty()) return;
  // Goals come before the scans, which controllers answer.
  for (RobotId robot = 0; robot < robots().size(); ++robot) topics_[robot]->publishGoal(robots()[robot], now, begins);
  publishTransforms(now);
  if (begins) publishMounts(now);
  for (const auto& topics : topics_) topics->publish(episode_->world(), *senses_, now);
  if (states_.getNumSubscribers() > 0) states_.publish(states(now));
}

void RobotInterface::publishTransforms(const ros::Time& now) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    topics_[robot]->addTransforms(robots()[robot], senses_->odometry(robot), now, publish_localisation_, transforms);
  }
  if (!transforms.empty()) transforms_->sendTransform(transforms);
}

void RobotInterface::publishMounts(const ros::Time& now) {
  std::vector<geometry_msgs::TransformStamped> mounts;
  mounts.reserve(topics_.size());
  for (const auto& topics : topics_) mounts.push_back(topics->mountTransform(now));
  static_transforms_->sendTransform(mounts);
}

social_crowd::RobotStates RobotInterface::states(const ros::Time& now) const {
  social_crowd::RobotStates message;
  message.header.frame_id = names::MAP_FRAME;
  message.header.stamp = now;
  message.episode = episode_->number();
  message.tick = episode_->world().tick();
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    message.robots.push_back(toMessage(robots()[robot], robot));
    writeCounts(commands_.countsOf(robot), message.robots.back());
    if (const auto poses = poses_.inputOf(robot)) writeCounts(*poses, message.robots.back());
  }
  return message;
}

std::vector<social_crowd::RobotObservation> RobotInterface::observations(
    const ros::Time& now, const social_crowd::StepRobots::Request& wanted) {
  std::vector<social_crowd::RobotObservation> observations;
  const std::vector<float> none;
  const World& world = episode_->world();
  // Services may have changed the world since the scans of this tick.
  if (episode_->changes() != scanned_changes_) senses_->forgetScans();
  scanned_changes_ = episode_->changes();
  std::vector<RobotResult> results;
  if (wanted.with_result != 0) results = episode_->result().robots;
  for (RobotId id = 0; id < robots().size(); ++id) {
    const Robot& robot = robots()[id];
    const std::vector<RobotContact>& contacts = contacts_.empty() ? robot.contacts : contacts_[id];
    social_crowd::RobotObservation observation = toMessage(robot.start, observeRobot(robot, world, contacts));
    observation.header.frame_id = names::MAP_FRAME;
    observation.header.stamp = now;
    const std::vector<float>& ranges = wanted.with_scan != 0 ? senses_->ranges(world, id) : none;
    observation.scan = topics_[id]->scanMessage(ranges, world.tickDuration(), now);
    if (wanted.with_people != 0) {
      for (const Neighbour& person : visiblePeople(world, id, *senses_)) {
        observation.people.push_back(toMessage(person));
      }
    }
    if (wanted.with_result != 0) observation.result.push_back(toMessage(results[id]));
    observations.push_back(observation);
  }
  return observations;
}

}  // namespace crowd
