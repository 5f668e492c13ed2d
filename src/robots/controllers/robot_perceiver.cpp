#include "robots/controllers/robot_perceiver.h"

#include <algorithm>

#include "robots/controllers/steering.h"

namespace crowd {

const Perceptions& RobotPerceiver::perceive(const World& world, const Vision& vision, RobotId id, const Vector2& goal) {
  const Vector2 point = finds_ways_ ? way_.next(world, world.robots()[id], goal) : goal;
  perceiver_.perceive(world, vision, viewers_.inPlaceOf(id, world, point), perceptions_);
  perceptions_.motion = MotionLimits();  // its drive limits the robot
  return perceptions_;
}

Vector2 wantedVelocity(const AgentPerception& self, const Vector2& goal) {
  const double left = (goal - self.pose.position).norm();
  const double distance = self.goal.norm();
  if (distance <= 0.0) return Vector2::Zero();
  return self.goal * (self.max_speed * std::min(1.0, left / SLOW_DOWN_DISTANCE) / distance);
}

}  // namespace crowd
