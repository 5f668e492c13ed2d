#include "ros/robots/robot_interface.h"

#include <std_msgs/String.h>
#include <tf2/utils.h>

#include <algorithm>
#include <utility>

#include "common/text/quotes.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

// On the topic names::NAVIGATION.
constexpr const char* NAVIGATION_RUNNING = "running";
constexpr const char* NAVIGATION_CRASHED = "crashed";

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

RobotInterface::RobotInterface(MainLoop& loop, const ros::NodeHandle& node, const RobotParameters& parameters,
                               std::function<ros::Time()> clock)
    : node_(node),
      clock_(clock),
      transforms_(parameters),
      visible_people_only_(parameters.visible_people_only),
      commands_(loop, parameters),
      poses_(node, std::move(clock)) {}

void RobotInterface::begin(Episode& episode) {
  episode_ = &episode;
  senses_ = std::make_unique<RobotSenses>(episode.scene(), visible_people_only_);
  contacts_.clear();
  scanned_changes_ = published_changes_ = episode.changes();
  commands_.begin(episode);
  for (RobotId id = 0; id < navigation_.size(); ++id) has_crashed_[id] = navigation_[id] == NAVIGATION_CRASHED;
  if (identitiesOf(robots()) != advertised_) advertise();
  poses_.begin(episode);
  for (RobotId id = 0; id < robots().size(); ++id) topics_[id]->begin(robots()[id].start);
}

void RobotInterface::advertise() {
  advertised_ = identitiesOf(robots());
  topics_.clear();
  navigation_.assign(robots().size(), "");
  has_crashed_.assign(robots().size(), false);
  commands_.forgetWarnings();
  poses_.subscribe(*episode_);
  for (RobotId id = 0; id < robots().size(); ++id) topics_.push_back(topicsOf(robots()[id].start, id));
  advertiseAll();
}

/// Handlers know the robot by its name: its id changes when one before it is removed.
std::unique_ptr<RobotTopics> RobotInterface::topicsOf(const RobotStart& start, RobotId id) {
  const auto present = [this, name = start.name] { return episode_->world().robots().idOf(name); };
  auto topics = std::make_unique<RobotTopics>(node_, start, id);
  if (start.drive != Drive::EXTERNAL) {
    const auto take = [this, present](const auto& command, const std::string& node) {
      commands_.take(present(), fromMessage(command), node);
    };
    topics->subscribe<geometry_msgs::Twist>(names::CMD_VEL, take, ros::TransportHints().tcpNoDelay());
  }
  topics->subscribe<geometry_msgs::PoseStamped>(
      "new_goal", [this, present](const auto& goal, const auto& /*node*/) { takeGoal(present(), goal); });
  topics->subscribe<geometry_msgs::PoseWithCovarianceStamped>(
      "new_pose", [this, present](const auto& pose, const auto& /*node*/) { takePose(present(), pose); });
  topics->subscribe<std_msgs::String>(names::NAVIGATION, [this, present](const auto& state, const auto& /*node*/) {
    noteNavigation(present(), state.data);
  });
  return topics;
}

void RobotInterface::requireFreeHands() const {
  if (commands_.isHolding()) throw InputError("steps of robots are in progress");
}

void RobotInterface::add(const RobotStart& start) {
  requireFreeHands();
  const RobotId id = episode_->edit().addRobot(start);
  senses_->add(start);
  commands_.add(start);
  navigation_.emplace_back();
  has_crashed_.push_back(false);
  topics_.push_back(topicsOf(start, id));
  noteRobots();
  const ros::Time now = clock_();
  topics_.back()->publishGoal(robots()[id], now, true);
  transforms_.publish(robots(), *senses_, topics_, now);
  transforms_.publishMounts(topics_, now);
}

void RobotInterface::remove(const std::string& name) {
  requireFreeHands();
  const RobotId id = episode_->world().robots().idOf(name);
  episode_->edit().removeRobot(id);
  senses_->remove(id);
  commands_.remove(id);
  navigation_.erase(navigation_.begin() + id);
  has_crashed_.erase(has_crashed_.begin() + id);
  transforms_.remove(id);
  topics_.erase(topics_.begin() + id);
  for (RobotId later = id; later < topics_.size(); ++later) topics_[later]->setId(later);
  noteRobots();
  publishStates(clock_());  // also if no robot is left
}

void RobotInterface::noteRobots() {
  advertised_ = identitiesOf(robots());
  poses_.subscribe(*episode_);
  poses_.begin(*episode_);
  scanned_changes_ = episode_->changes();
  senses_->forgetScans();
  advertiseAll();
}

/// The topics of all robots together.
void RobotInterface::advertiseAll() {
  if (robots().empty() || states_) return;
  transforms_.advertise();
  states_ = node_.advertise<social_crowd::RobotStates>(names::ROBOTS, QUEUE,
                                                       [this](const ros::SingleSubscriberPublisher& subscriber) {
                                                         if (!robots().empty()) subscriber.publish(states(clock_()));
                                                       });
}

void RobotInterface::noteNavigation(RobotId robot, const std::string& state) {
  const char* const name = robots()[robot].start.name.c_str();
  if (state != NAVIGATION_RUNNING && state != NAVIGATION_CRASHED) {
    ROS_WARN("robot '%s': %s: expected %s or %s, got %s", name, names::NAVIGATION, NAVIGATION_RUNNING,
             NAVIGATION_CRASHED, inQuotes(state).c_str());
    return;
  }
  const bool has_crashed = state == NAVIGATION_CRASHED;
  if (has_crashed && navigation_[robot] != state) ROS_ERROR("robot '%s': navigation: crashed", name);
  navigation_[robot] = state;
  has_crashed_[robot] = has_crashed_[robot] || has_crashed;
  commands_.abandon(robot, has_crashed);
}

std::string RobotInterface::navigationOf(RobotId robot) const {
  if (has_crashed_[robot]) return NAVIGATION_CRASHED;
  return navigation_[robot].empty() ? RobotInput().navigation : navigation_[robot];
}

template <typename Change>
bool RobotInterface::change(RobotId robot, const char* what, const std::string& frame, const Change& change) {
  try {
    if (frame != names::MAP_FRAME && !frame.empty()) throw InputError("expected the frame map, got " + frame);
    change(episode_->edit());
  } catch (const InputError& error) {
    ROS_WARN("robot '%s': a %s is refused: %s", robots()[robot].start.name.c_str(), what, error.what());
    return false;
  }
  return true;
}

void RobotInterface::takeGoal(RobotId robot, const geometry_msgs::PoseStamped& goal) {
  const auto send = [&](EpisodeEditor editor) { editor.sendRobot(robot, fromPoint(goal.pose.position)); };
  if (!change(robot, "goal", goal.header.frame_id, send)) return;
  topics_[robot]->publishGoal(robots()[robot], clock_(), true);
}

void RobotInterface::takePose(RobotId robot, const geometry_msgs::PoseWithCovarianceStamped& pose) {
  change(robot, "pose", pose.header.frame_id, [&](EpisodeEditor editor) {
    editor.teleportRobot(robot, {fromPoint(pose.pose.pose.position), tf2::getYaw(pose.pose.pose.orientation)});
  });
}

bool RobotInterface::wait(const std::function<ros::Time()>& end) {
  if (robots().empty()) return true;
  if (!commands_.wait()) return false;
  poses_.place(end());
  return true;
}

RobotInput RobotInterface::inputOf(RobotId robot) const {
  RobotInput input;
  input.navigation = navigationOf(robot);
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
  if (!begins) transforms_.publishBetween(episode_->world(), *senses_, topics_, now);
  transforms_.publish(robots(), *senses_, topics_, now);
  if (begins) transforms_.publishMounts(topics_, now);
  for (const auto& topics : topics_) topics->publish(episode_->world(), *senses_, now);
  publishStates(now);
}

void RobotInterface::publishChanges() {
  if (!robots().empty() && published_changes_ != episode_->changes()) publishStates(clock_());
}

void RobotInterface::publishStates(const ros::Time& now) {
  published_changes_ = episode_->changes();
  if (states_ && states_.getNumSubscribers() > 0) states_.publish(states(now));
}

social_crowd::RobotStates RobotInterface::states(const ros::Time& now) const {
  social_crowd::RobotStates message;
  message.header.frame_id = names::MAP_FRAME;
  message.header.stamp = now;
  message.episode = episode_->number();
  message.tick = episode_->world().tick();
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    message.robots.push_back(toMessage(robots()[robot], robot));
    message.robots.back().navigation = navigationOf(robot);
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
