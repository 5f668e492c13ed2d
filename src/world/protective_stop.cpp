#include "social_crowd/world/protective_stop.h"

#include <algorithm>
#include <cmath>

#include "social_crowd/world/impact.h"
#include "social_crowd/world/robot_sweep.h"

namespace crowd {

Twist protectiveTwist(const Robot& robot, const World& world) {
  const double tick = world.tickDuration();
  const DriveLimits& limits = robot.start.limits;
  Twist twist = robot.target;
  const double speed = std::min(twist.linear.norm(), limits.max_speed);
  const double rotation = std::min(std::abs(twist.rotation), limits.max_rotation);
  // At a constant twist it needs this time for the way on which it stops.
  const double braking = std::max(speed / limits.max_acceleration, rotation / limits.max_rotation_acceleration) / 2.0;
  const double horizon = braking + tick;
  if (speed + rotation <= 0.0) return twist;
  if (speed > 0.0) twist.linear *= speed / twist.linear.norm();
  twist.rotation = std::copysign(rotation, twist.rotation);
  const RobotSweep sweep(robot.start.footprint, robot.pose, twist, horizon);
  double free = 1.0;
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    const double radius = agent.radius + agent.max_speed * tick;
    free = std::min(free, firstTouch(sweep, agent.pose.position, Vector2::Zero(), radius, 0.0));
  }
  if (free >= 1.0) return twist;
  // The share k of the twist, for which braking k^2 + tick k = free horizon.
  const double free_time = free * horizon;
  const double share =
      braking > 0.0 ? (std::sqrt(tick * tick + 4.0 * braking * free_time) - tick) / (2.0 * braking) : free_time / tick;
  return {share * twist.linear, share * twist.rotation};
}

}  // namespace crowd
