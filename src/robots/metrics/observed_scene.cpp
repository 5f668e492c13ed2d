#include "robots/metrics/observed_scene.h"

#include "navigation/walking_floor.h"

namespace crowd {

void ObservedScene::observe(const World& world) {
  tick_duration = world.tickDuration();
  robots.clear();
  for (const Robot& robot : world.robots()) robots.push_back({&robot, &robot.contacts});
  people.clear();
  for (const Agent& agent : world.agents()) {
    if (!agent.isPresent()) continue;
    people.push_back({agent.id, agent.pose.position, agent.pose.heading, agent.velocity, agent.radius, agent.group});
  }
  obstacles.clear();
  for (std::size_t i = 0; i < world.obstacles().size(); ++i) {
    const Obstacle& obstacle = world.obstacles()[i];
    if (!world.isPresent(obstacle)) continue;
    const auto [place, velocity] = obstacle.path.at(world.time());
    if (obstacle.person) {
      people.push_back({idOfRecorded(i), place, bearingOf(velocity), velocity, obstacle.radius});
    } else {
      obstacles.push_back({place, obstacle.radius, obstacle.path.moves()});
    }
  }
  walls = &world.walls().index();
}

FloorPlan floorOf(const ObservedScene& scene, const std::vector<Segment>& gates) {
  FloorPlan floor;
  floor.walls = scene.walls->walls();
  openGates(gates, floor);
  for (const ObservedObstacle& obstacle : scene.obstacles) {
    if (!obstacle.moves) floor.obstacles.push_back({obstacle.position, obstacle.radius});
  }
  return floor;
}

}  // namespace crowd
