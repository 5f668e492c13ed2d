#include "robots/controllers/social_force_robot.h"

#include <algorithm>

#include "robots/controllers/steering.h"

namespace crowd {
namespace {

/// The sum of all forces on the robot [m/s^2].
Vector2 forceOn(const Perception& perception, const Vector2& goal) {
  const AgentPerception& self = perception.self;
  Vector2 sum = social_force::drivingForce(self.velocity, wantedVelocity(self, goal));
  const auto add = [&](const Vector2& force) { sum += social_force::sightWeight(self.goal, force) * force; };
  for (const Neighbour& body : perception.neighbours) add(social_force::bodyForce(body, self.radius));
  const auto is_nearer = [](const Segment& one, const Segment& other) {
    return distanceTo(one, Vector2::Zero()) < distanceTo(other, Vector2::Zero());
  };
  const auto nearest = std::min_element(perception.walls.begin(), perception.walls.end(), is_nearer);
  if (nearest != perception.walls.end()) sum += social_force::wallForce(*nearest);
  return sum;
}

}  // namespace

Twist SocialForceRobot::command(const World& world, RobotId id, const Vector2& goal) {
  const Robot& robot = world.robots()[id];
  const Perception perception(perceiver_.perceive(world, PLANNER_VISION, id, goal), 0);
  Vector2 velocity = perception.self.velocity + perception.tick_duration * forceOn(perception, goal);
  if (velocity.norm() > perception.self.max_speed) velocity *= perception.self.max_speed / velocity.norm();
  return steer(robot.start.drive, bearingOf(velocity), velocity.norm());
}

}  // namespace crowd
