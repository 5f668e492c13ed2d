#include "social_crowd/ros/robot_interfaces.h"

#include <social_crowd/RobotStates.h>

#include <algorithm>
#include <cmath>

#include "social_crowd/common/numbers.h"
#include "social_crowd/ros/conversions.h"
#include "social_crowd/ros/names.h"

namespace crowd {
namespace {

constexpr std::uint32_t QUEUE = 100;  // messages
const ros::WallDuration IDLE(0.1);    // between two checks for shutdown

CommandSettings settingsOf(const ControllerParameters& parameters) {
  CommandSettings settings;
  settings.lockstep = parameters.robot_lockstep;
  settings.period = parameters.command_period;
  settings.misses_until_absent = parameters.misses_until_absent;
  return settings;
}

std::vector<std::string> identitiesOf(const std::vector<Robot>& robots) {
  std::vector<std::string> identities;
  identities.reserve(robots.size());
  for (const Robot& robot : robots) identities.push_back(robot.start.name + " " + robot.start.name_space);
  return identities;
}

}  // namespace

RobotInterfaces::RobotInterfaces(MainLoop& loop, const ros::NodeHandle& node, const ControllerParameters& parameters)
    : loop_(loop),
      node_(node),
      command_deadline_(parameters.command_deadline),
      publish_localisation_(parameters.publish_localisation),
      commands_(settingsOf(parameters)) {}

void RobotInterfaces::begin(Episode& episode) {
  cancelled_ = true;
  episode_ = &episode;
  senses_ = std::make_unique<RobotSenses>(episode.scene());
  std::vector<double> timeouts;
  for (const Robot& robot : robots()) timeouts.push_back(robot.start.cmd_timeout);
  commands_.begin(timeouts, episode.scene().tick_duration);
  if (identitiesOf(robots()) != advertised_) advertise();
  for (RobotId id = 0; id < robots().size(); ++id) interfaces_[id]->begin(robots()[id].start);
}

void RobotInterfaces::advertise() {
  advertised_ = identitiesOf(robots());
  interfaces_.clear();
  warned_.clear();
  for (RobotId id = 0; id < robots().size(); ++id) {
    RobotInterface::Handlers handlers;
    handlers.command = [this, id](const Twist& command, const std::string& node) { take(id, command, node); };
    handlers.goal = [this, id](const geometry_msgs::PoseStamped& goal) { takeGoal(id, goal); };
    interfaces_.push_back(std::make_unique<RobotInterface>(node_, robots()[id].start, id, std::move(handlers)));
  }
  if (robots().empty() || transforms_) return;
  transforms_.emplace();
  static_transforms_.emplace();
  states_ = node_.advertise<social_crowd::RobotStates>(names::ROBOTS, QUEUE);
}

PublisherId RobotInterfaces::numberOf(const std::string& node) {
  const auto found = std::find(publishers_.begin(), publishers_.end(), node);
  if (found == publishers_.end()) publishers_.push_back(node);
  return static_cast<PublisherId>(std::find(publishers_.begin(), publishers_.end(), node) - publishers_.begin());
}

void RobotInterfaces::take(RobotId robot, const Twist& command, const std::string& node) {
  const std::optional<CommandRefusal> cause = commands_.take(robot, command, numberOf(node), tick());
  if (cause) warnOfRefusal(robot, *cause, node);
}

void RobotInterfaces::warnOfRefusal(RobotId robot, CommandRefusal cause, const std::string& node) {
  if (!warned_.insert({robot, cause, numberOf(node)}).second) return;
  const std::string& name = robots()[robot].start.name;
  std::string reason = "it contains a number that is not finite";
  if (cause == CommandRefusal::OTHER_PUBLISHER) {
    const std::optional<PublisherId> holder = commands_.holderOf(robot, tick());
    reason = "node " + (holder ? publishers_[*holder] : std::string("?")) + " commands this robot";
  } else if (cause == CommandRefusal::SECOND_IN_TICK) {
    reason = "the robot has a command for this tick already";
  }
  ROS_WARN("robot '%s': a command of node %s is refused: %s. Further ones are only counted, on %s", name.c_str(),
           node.c_str(), reason.c_str(), states_.getTopic().c_str());
}

void RobotInterfaces::takeGoal(RobotId robot, const geometry_msgs::PoseStamped& goal) {
  const std::string& name = robots()[robot].start.name;
  const std::string& frame = goal.header.frame_id;
  const Vector2 place = fromPoint(goal.pose.position);
  if (frame != names::MAP_FRAME && !frame.empty()) {
    ROS_WARN("robot '%s': a goal is refused: expected the frame map, got %s", name.c_str(), frame.c_str());
  } else if (!place.allFinite()) {
    ROS_WARN("robot '%s': a goal is refused: expected finite numbers, got %s", name.c_str(),
             (toText(place.x()) + ", " + toText(place.y())).c_str());
  } else {
    episode_->setRobotGoals(robot, {place});
    interfaces_[robot]->publishGoal(robots()[robot], ros::Time::now(), true);
  }
}

void RobotInterfaces::ask() {
  cancelled_ = false;
  deadline_ = Clock::now() + ros::WallDuration(command_deadline_);
}

bool RobotInterfaces::wait() {
  if (robots().empty()) return true;
  while (!held_ && !cancelled_ && !loop_.isClosed() && commands_.isAnyAwaited(tick()) && Clock::now() < deadline_) {
    loop_.run(std::max(ros::WallDuration(0.0), std::min(IDLE, deadline_ - Clock::now())));
  }
  if (cancelled_ || loop_.isClosed()) return false;
  if (!held_) warnOfAbsence(commands_.giveUp(tick()));
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    if (robots()[robot].start.drive == Drive::EXTERNAL) continue;
    const Twist command = commands_.commandFor(robot, tick());
    const auto held = held_ ? held_->find(robot) : Commands::const_iterator();
    episode_->commandRobot(robot, held_ && held != held_->end() ? held->second : command);
  }
  return true;
}

bool RobotInterfaces::isAnyUnattended() const {
  if (held_) return false;
  return std::any_of(robots().begin(), robots().end(), [this](const Robot& robot) {
    const bool drives = robot.start.drive != Drive::EXTERNAL && robot.hasGoal() && !robot.hasArrived();
    return drives && commands_.isUnattended(static_cast<RobotId>(&robot - robots().data()));
  });
}

void RobotInterfaces::warnOfAbsence(const std::vector<RobotId>& absent) const {
  for (const RobotId robot : absent) {
    ROS_WARN(
        "robot '%s': no command within %g s in several ticks in a row; it is not waited for until its next command",
        robots()[robot].start.name.c_str(), command_deadline_);
  }
}

void RobotInterfaces::publish(const ros::Time& now, bool begins) {
  if (robots().empty()) return;
  publishTransforms(now, begins);
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    interfaces_[robot]->publish(episode_->world(), *senses_, now);
    interfaces_[robot]->publishGoal(robots()[robot], now, begins);
  }
  publishStates(now);
}

void RobotInterfaces::publishTransforms(const ros::Time& now, bool begins) {
  std::vector<geometry_msgs::TransformStamped> transforms;
  std::vector<geometry_msgs::TransformStamped> mounts;
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    interfaces_[robot]->addTransforms(robots()[robot], senses_->odometry(robot), now, publish_localisation_,
                                      transforms);
    mounts.push_back(interfaces_[robot]->mountTransform(now));
  }
  if (!transforms.empty()) transforms_->sendTransform(transforms);
  if (begins) static_transforms_->sendTransform(mounts);
}

void RobotInterfaces::publishStates(const ros::Time& now) {
  if (states_.getNumSubscribers() == 0) return;
  social_crowd::RobotStates message;
  message.header.frame_id = names::MAP_FRAME;
  message.header.stamp = now;
  message.episode = episode_->number();
  message.tick = tick();
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    message.robots.push_back(toMessage(robots()[robot], robot));
    writeCounts(commands_.countsOf(robot), message.robots.back());
  }
  states_.publish(message);
}

RobotInterfaces::Commands RobotInterfaces::commandsOf(const std::vector<std::string>& names,
                                                      const std::vector<geometry_msgs::Twist>& commands) const {
  if (robots().empty()) throw InputError("there are no robots in this episode");
  if (names.size() != commands.size()) {
    throw InputError("commands: expected one for each of " + std::to_string(names.size()) + " robots, got " +
                     std::to_string(commands.size()));
  }
  Commands result;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto is_it = [&](const Robot& robot) { return robot.start.name == names[i]; };
    const auto robot = std::find_if(robots().begin(), robots().end(), is_it);
    if (robot == robots().end()) throw InputError("robots: there is no robot '" + names[i] + "'");
    const Twist twist = fromMessage(commands[i]);
    if (!twist.isFinite()) throw InputError("commands: expected finite numbers for robot '" + names[i] + "'");
    if (robot->start.drive == Drive::EXTERNAL) throw InputError("robot '" + names[i] + "' takes no commands");
    const auto id = static_cast<RobotId>(robot - robots().begin());
    if (!result.emplace(id, twist).second) throw InputError("robots: '" + names[i] + "' is there twice");
  }
  return result;
}

std::vector<social_crowd::RobotObservation> RobotInterfaces::observations(const ros::Time& now, bool with_scan) {
  std::vector<social_crowd::RobotObservation> observations;
  const std::vector<float> none;
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    social_crowd::RobotObservation observation = toObservation(robots()[robot], episode_->world());
    observation.header.frame_id = names::MAP_FRAME;
    observation.header.stamp = now;
    observation.scan = interfaces_[robot]->scanMessage(with_scan ? senses_->ranges(episode_->world(), robot) : none,
                                                       episode_->world().tickDuration(), now);
    observations.push_back(observation);
  }
  return observations;
}

}  // namespace crowd
