#include <string>
#include <utility>

#include "geometry/finite_checks.h"
#include "social_crowd/common/errors.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/common/quotes.h"
#include "social_crowd/world/world.h"

namespace crowd {
namespace {

/// A disc touches nothing by turning, so it goes on to turn for the rest of the tick [s]; other robots stand.
void stopAtImpact(Robot& robot, double rest) {
  const bool turns = robot.start.footprint.isDisc() && robot.start.drive != Drive::ACKERMANN;
  robot.twist = {Vector2::Zero(), turns ? robot.twist.rotation : 0.0};
  robot.pose.heading = wrapAngle(robot.pose.heading + rest * robot.twist.rotation);
}

}  // namespace

void World::addRobot(const RobotStart& start) {
  Robot& robot = robots_.emplace_back();
  robot.start = start;
  robot.pose = {start.position, wrapAngle(start.heading)};
  robot.goals = start.goals;
  robot.perceived_radius = start.footprint.reach() + deviation(start.limits, tick_duration_);
  robot_places_.emplace_back();
  robot_contacts_.emplace_back();
}

Robot& World::findRobot(RobotId id) {
  if (id >= robots_.size()) throw InputError("there is no robot " + std::to_string(id));
  return robots_[id];
}

void World::commandRobot(RobotId id, const Twist& wanted) {
  Robot& robot = findRobot(id);
  const std::string name = "robot " + inQuotes(robot.start.name);
  if (robot.start.drive == Drive::EXTERNAL) throw InputError(name + " is external: it takes no commands");
  if (!wanted.isFinite()) {
    throw InputError(name + ": expected a command of finite numbers, got linear " +
                     toText(std::vector<double>{wanted.linear.x(), wanted.linear.y()}) + ", rotation " +
                     toText(wanted.rotation));
  }
  robot.target = wanted;
}

void World::placeRobot(RobotId id, const Pose& pose, const Vector2& velocity, bool jump) {
  const Robot& robot = findRobot(id);
  if (robot.start.drive != Drive::EXTERNAL) {
    throw InputError("robot " + inQuotes(robot.start.name) + " is not external: it moves by commands");
  }
  requirePose(pose);
  requireWithin(limits::VELOCITY, "velocity [m/s]", velocity);
  robot_places_[id] = RobotPlace{{pose.position, wrapAngle(pose.heading)}, velocity, jump};
}

void World::setRobotGoals(RobotId id, std::vector<Vector2> goals) {
  Robot& robot = findRobot(id);
  for (const Vector2& goal : goals) requirePlace("goal [m]", goal);
  robot.goals = std::move(goals);
  robot.next_goal = 0;
  robot.status = RobotStatus::DRIVING;
}

void World::teleportRobot(RobotId id, const Pose& pose) {
  Robot& robot = findRobot(id);
  requirePose(pose);
  const std::string blocker = findBlocker(pose.position, robot.start.footprint.reach(), false, std::nullopt, id);
  if (!blocker.empty()) throw InputError("the place is taken by " + blocker);
  robot.pose = {pose.position, wrapAngle(pose.heading)};
  robot.twist = Twist();
  robot.velocity = Vector2::Zero();
  robot_places_[id].reset();
}

void World::beginRobotMoves() {
  robot_sweeps_.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    robot.blocked = false;
    robot.jumped = false;
    const Footprint& footprint = robot.start.footprint;
    if (robot.start.drive != Drive::EXTERNAL) {
      robot.twist = doesRobotYield(robot.start.yields)
                        ? protective_stop_.next(robot, agents_.values(), tick_duration_)
                        : limitTwist(robot.start.drive, robot.start.limits, robot.twist, robot.target, tick_duration_);
      robot_sweeps_.emplace_back(footprint, robot.pose, robot.twist, tick_duration_);
      continue;
    }
    robot.velocity = Vector2::Zero();
    const Pose from = robot.pose;
    if (const auto place = std::exchange(robot_places_[i], std::nullopt)) {
      robot.pose = place->pose;
      robot.jumped = place->jump;
      if (!place->jump) robot.velocity = place->velocity;
    }
    robot_sweeps_.emplace_back(footprint, robot.jumped ? robot.pose : from, robot.pose);
  }
}

void World::holdRobots() {
  robot_sweeps_.clear();
  for (const Robot& robot : robots_) {
    robot_sweeps_.emplace_back(robot.start.footprint, robot.pose, Twist(), tick_duration_);
  }
}

void World::addRobotDiscs() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotSweep& sweep = robot_sweeps_[i];
    const bool can_stop = robots_[i].start.drive != Drive::EXTERNAL;
    discs_.push_back({sweep.at(0.0).position, Vector2::Zero(), sweep.footprint().reach(), can_stop, &sweep});
  }
}

void World::moveRobots() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    robot.contacts.swap(robot_contacts_[i]);
    robot_contacts_[i].clear();
    if (robot.start.drive == Drive::EXTERNAL) {
      robot.twist = {Rotation(robot.pose.heading).intoFrame(robot.velocity), 0.0};
      continue;
    }
    const RobotSweep& sweep = robot_sweeps_[i];
    robot.pose = sweep.at(1.0);
    robot.blocked = sweep.stoppedAt() < 1.0 && !(robot.twist.linear.isZero(0.0) && robot.twist.rotation == 0.0);
    if (sweep.stoppedAt() < 1.0) stopAtImpact(robot, (1.0 - sweep.stoppedAt()) * tick_duration_);
    robot.velocity = Rotation(robot.pose.heading).outOfFrame(robot.twist.linear);
  }
}

void World::endRobotMoves() {
  for (Robot& robot : robots_) {
    if (!robot.hasGoal() || robot.hasArrived()) continue;
    if ((robot.goal() - robot.pose.position).norm() > robot.start.goal_tolerance) continue;
    if (robot.next_goal + 1 < robot.goals.size()) {
      ++robot.next_goal;
    } else {
      robot.status = RobotStatus::ARRIVED;
    }
  }
}

}  // namespace crowd
