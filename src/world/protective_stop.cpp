#include "world/protective_stop.h"

#include <algorithm>

#include "geometry/impact.h"
#include "geometry/robot_sweep.h"

namespace crowd {
namespace {

constexpr int HALVINGS = 10;  // of the interval that contains the share

/// A commanded twist without what the limits never permit, so that all of its shares are of use.
Twist clamped(const Twist& twist, const DriveLimits& limits) {
  const double speed = twist.linear.norm();
  const double share = speed > limits.max_speed ? limits.max_speed / speed : 1.0;
  return {share * twist.linear, std::clamp(twist.rotation, -limits.max_rotation, limits.max_rotation)};
}

}  // namespace

Twist ProtectiveStop::next(const Robot& robot, const std::vector<Agent>& agents, const std::vector<Neighbour>& recorded,
                           double tick_duration) {
  findPeople(robot, agents, recorded, tick_duration);
  const DriveLimits& limits = robot.start.limits;
  const Twist wanted = clamped(robot.target, limits);
  const auto permitted = [&](double linear, double rotation) {
    const Twist reduced{linear * wanted.linear, rotation * wanted.rotation};
    return limitTwist(robot.start.drive, limits, robot.twist, reduced, tick_duration);
  };
  Twist twist = permitted(1.0, 1.0);
  if (isFree(robot, twist, tick_duration)) return twist;
  twist = permitted(0.0, 1.0);
  const bool may_turn = isFree(robot, twist, tick_duration);
  if (!may_turn) twist = permitted(0.0, 0.0);
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < HALVINGS; ++i) {
    const double middle = 0.5 * (low + high);
    const Twist reduced = permitted(middle, may_turn ? 1.0 : middle);
    const bool is_free = isFree(robot, reduced, tick_duration);
    (is_free ? low : high) = middle;
    if (is_free) twist = reduced;
  }
  return twist;
}

void ProtectiveStop::findPeople(const Robot& robot, const std::vector<Agent>& agents,
                                const std::vector<Neighbour>& recorded, double tick_duration) {
  people_.clear();
  const DriveLimits& limits = robot.start.limits;
  const double speed = std::max(robot.twist.linear.norm(), limits.max_speed);
  // It comes to rest within this distance, because braking begins after a tick.
  const double reach =
      robot.start.footprint.reach() + speed * tick_duration + 0.5 * speed * speed / limits.max_acceleration;
  const auto add = [&](const Vector2& position, double radius) {
    if ((position - robot.pose.position).norm() <= reach + radius) people_.push_back({position, radius});
  };
  for (const Agent& agent : agents) {
    const double way = agent.isWalking() ? agent.max_speed * tick_duration : 0.0;  // at most, in a tick
    if (agent.isPresent()) add(agent.pose.position, agent.radius + way);
  }
  for (const Neighbour& person : recorded) add(person.position, person.radius + person.velocity.norm() * tick_duration);
}

/// Returns whether the robot does not touch any person if it moves at this twist for a tick and then brakes.
bool ProtectiveStop::isFree(const Robot& robot, Twist twist, double tick_duration) const {
  if (people_.empty()) return true;
  const RobotStart& start = robot.start;
  Pose pose = robot.pose;
  for (;;) {
    const RobotSweep sweep(start.footprint, pose, twist, tick_duration);
    if (sweep.pointSpeed() <= 0.0) return true;
    const bool touches = std::any_of(people_.begin(), people_.end(), [&](const Person& person) {
      return firstTouch(sweep, person.position, Vector2::Zero(), person.radius, 0.0) < NO_IMPACT;
    });
    if (touches) return false;
    pose = sweep.at(1.0);
    twist = limitTwist(start.drive, start.limits, twist, Twist(), tick_duration);
  }
}

}  // namespace crowd
