#include "robots/controllers/orca_robot.h"

#include "robots/controllers/steering.h"

namespace crowd {

Twist OrcaRobot::command(const World& world, RobotId id, const Vector2& goal) {
  const Robot& robot = world.robots()[id];
  const Perceptions& all = perceiver_.perceive(world, PLANNER_VISION, id, goal);
  const Perception perception(all, 0);
  const AgentPerception& self = perception.self;
  planes_.clear();
  for (const Segment& wall : perception.walls) {
    planes_.push_back(orca::avoid(wall, self.radius, WALL_HORIZON, perception.tick_duration));
  }
  const std::size_t fixed = planes_.size();
  const double radius = self.radius + (robot.start.drive == Drive::HOLONOMIC ? 0.0 : TRACKING_ERROR);
  for (const Neighbour& body : perception.neighbours) {
    const double share = body.kind == NeighbourKind::AGENT ? 0.5 : 1.0;
    planes_.push_back(orca::avoid(body, radius, self.velocity, share, HORIZON, perception.tick_duration));
  }
  const Vector2 velocity = orca::nearestVelocity(planes_, fixed, self.max_speed, wantedVelocity(self, goal));
  return steer(robot.start.drive, bearingOf(velocity), velocity.norm());
}

}  // namespace crowd
