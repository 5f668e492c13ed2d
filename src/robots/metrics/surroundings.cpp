#include "robots/metrics/surroundings.h"

#include <algorithm>

namespace crowd {

double Surroundings::wallDistance(const ObservedScene& scene, const Robot& robot) {
  const Footprint& footprint = robot.start.footprint;
  const double from_middle = scene.walls->nearestDistance(robot.pose.position, INFINITE);
  if (footprint.isDisc() || from_middle == INFINITE) return from_middle - footprint.radius;
  // A wall that is farther from the middle than this is farther from the footprint than the nearest one.
  near_walls_.clear();
  scene.walls->findNear(robot.pose.position, from_middle + footprint.reach(), near_walls_);
  double nearest = INFINITE;
  for (const std::uint32_t number : near_walls_) {
    nearest = std::min(nearest, distance(footprint, robot.pose, scene.walls->walls()[number]));
  }
  return nearest;
}

double Surroundings::obstacleDistance(const ObservedScene& scene, const Robot& robot) {
  double nearest = INFINITE;
  for (const ObservedObstacle& obstacle : scene.obstacles) {
    nearest = std::min(nearest, distance(robot.start.footprint, robot.pose, obstacle.position) - obstacle.radius);
  }
  return nearest;
}

double Surroundings::clearanceOf(const ObservedScene& scene, const ObservedPerson& person) {
  double nearest = scene.walls->nearestDistance(person.position, INFINITE);
  for (const ObservedObstacle& obstacle : scene.obstacles) {
    nearest = std::min(nearest, (person.position - obstacle.position).norm() - obstacle.radius);
  }
  return nearest - person.radius;
}

}  // namespace crowd
