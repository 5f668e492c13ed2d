#include "ros/robots/command_collector.h"

#include <algorithm>

#include "common/text/quotes.h"
#include "ros/messages/names.h"
#include "ros/messages/topic_defaults.h"
#include "ros/robots/robot_messages.h"

namespace crowd {
namespace {

CommandSettings settingsOf(const RobotParameters& parameters) {
  CommandSettings settings;
  settings.lockstep = parameters.robot_lockstep;
  settings.period = parameters.command_period;
  settings.misses_until_absent = parameters.misses_until_absent;
  return settings;
}

}  // namespace

CommandCollector::CommandCollector(MainLoop& loop, const RobotParameters& parameters)
    : loop_(loop), parameters_(parameters), commands_(settingsOf(parameters)) {}

void CommandCollector::begin(Episode& episode) {
  cancelled_ = true;
  episode_ = &episode;
  std::vector<double> timeouts;
  for (const Robot& robot : robots()) timeouts.push_back(robot.start.cmd_timeout);
  commands_.begin(timeouts, episode.scene().tick_duration);
}

CommandCounts CommandCollector::totals() const {
  CommandCounts totals;
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    const CommandCounts& counts = countsOf(robot);
    totals.taken += counts.taken;
    totals.timeouts += counts.timeouts;
    totals.missed += counts.missed;
    totals.late += counts.late;
    totals.newer += counts.newer;
    for (std::size_t i = 0; i < counts.refused.size(); ++i) totals.refused[i] += counts.refused[i];
  }
  return totals;
}

void CommandCollector::remove(RobotId robot) {
  commands_.remove(robot);
  warned_.clear();
  warned_of_lateness_.clear();
  std::map<RobotId, bool> abandoned;
  for (const auto& [id, is_abandoned] : abandoned_) {
    if (id != robot) abandoned[id > robot ? id - 1 : id] = is_abandoned;
  }
  abandoned_ = std::move(abandoned);
}

PublisherId CommandCollector::numberOf(const std::string& node) {
  const auto found = std::find(publishers_.begin(), publishers_.end(), node);
  const auto number = static_cast<PublisherId>(found - publishers_.begin());
  if (found == publishers_.end()) publishers_.push_back(node);
  return number;
}

void CommandCollector::take(RobotId robot, const Twist& command, const std::string& node) {
  const std::uint64_t late = commands_.countsOf(robot).late;
  const std::optional<CommandRefusal> cause = commands_.take(robot, command, numberOf(node), tick());
  if (cause) warnOfRefusal(robot, *cause, node);
  if (commands_.countsOf(robot).late > late) warnOfLateness(robot, node);
}

void CommandCollector::warnOfRefusal(RobotId robot, CommandRefusal cause, const std::string& node) {
  if (!warned_.insert({robot, cause, numberOf(node)}).second) return;
  const std::string& name = robots()[robot].start.name;
  std::string reason = "it contains a number that is not finite";
  if (cause == CommandRefusal::OTHER_PUBLISHER) {
    const std::optional<PublisherId> holder = commands_.holderOf(robot, tick());
    reason = "node " + (holder ? publishers_[*holder] : std::string("?")) + " commands this robot";
  }
  ROS_WARN("robot '%s': a command of node %s is refused: %s. Further ones are only counted, on %s", name.c_str(),
           node.c_str(), reason.c_str(), names::ROBOTS);
}

void CommandCollector::warnOfLateness(RobotId robot, const std::string& node) {
  if (!warned_of_lateness_.insert(robot).second) return;
  ROS_WARN(
      "robot '%s': a command of node %s came after the %g s of ~command_deadline; it is executed now, unless that of "
      "this tick comes in time. Further ones are only counted, on %s",
      robots()[robot].start.name.c_str(), node.c_str(), parameters_.command_deadline, names::ROBOTS);
}

void CommandCollector::ask() {
  cancelled_ = false;
  commands_.setMissesUntilAbsent(parameters_.misses_until_absent);
  wait_until_ = Clock::now() + ros::WallDuration(parameters_.command_deadline);
}

bool CommandCollector::awaitLast() {
  ask();
  return await();
}

bool CommandCollector::await() {
  while (!held_ && !cancelled_ && !loop_.isClosed() && commands_.isAnyAwaited(tick()) && Clock::now() < wait_until_) {
    loop_.run(std::max(ros::WallDuration(0.0), std::min(IDLE, wait_until_ - Clock::now())));
  }
  return !cancelled_ && !loop_.isClosed();
}

bool CommandCollector::wait() {
  if (!await()) return false;
  if (!held_) warnOfAbsence(commands_.giveUp(tick()));
  for (RobotId robot = 0; robot < robots().size(); ++robot) {
    if (robots()[robot].start.drive != Drive::EXTERNAL) episode_->robots().command(robot, commandFor(robot));
  }
  return true;
}

bool CommandCollector::isAnyUnattended() const {
  if (held_) return false;
  return std::any_of(robots().begin(), robots().end(), [this](const Robot& robot) {
    const bool drives = robot.start.drive != Drive::EXTERNAL && robot.hasGoal() && !robot.hasArrived();
    const auto id = static_cast<RobotId>(&robot - robots().data());
    const auto abandoned = abandoned_.find(id);
    return drives && commands_.isUnattended(id) && (abandoned == abandoned_.end() || !abandoned->second);
  });
}

Twist CommandCollector::commandFor(RobotId robot) {
  if (held_) {
    const auto held = held_->find(robot);
    if (held != held_->end()) return held->second;
  }
  return commands_.commandFor(robot, tick());
}

void CommandCollector::warnOfAbsence(const std::vector<RobotId>& absent) const {
  for (const RobotId robot : absent) {
    ROS_WARN(
        "robot '%s': no command within %g s in several ticks in a row; it is not waited for until its next command",
        robots()[robot].start.name.c_str(), parameters_.command_deadline);
  }
}

CommandCollector::Commands CommandCollector::commandsOf(const std::vector<std::string>& names,
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
    if (robot == robots().end()) throw InputError("robots: there is no robot " + inQuotes(names[i]));
    const Twist twist = fromMessage(commands[i]);
    if (!twist.isFinite()) throw InputError("commands: expected finite numbers for robot " + inQuotes(names[i]));
    if (robot->start.drive == Drive::EXTERNAL) throw InputError("robot " + inQuotes(names[i]) + " takes no commands");
    const auto id = static_cast<RobotId>(robot - robots().begin());
    if (!result.emplace(id, twist).second) throw InputError("robots: " + inQuotes(names[i]) + " is there twice");
  }
  return result;
}

}  // namespace crowd
