#include "robots/metrics/surroundings.h"

#include <algorithm>

namespace crowd {

double Surroundings::wallDistance(const ObservedScene& scene, const Robot& robot) {
  const Footprint& footprint = robot.start.footprint;
  const double from_middle = scene.walls->nearestDistance(robot.pose.position, INFINITE);
  if (footprint.isDisc() || from_middle == INFINITE) return from_middle - footprint.radius;
  // The wall that is nearest to the origin of the footprint is within from_middle + reach of the footprint, so one that
  // is farther from the origin than this is farther from the footprint. The origin may be outside the footprint.
  near_walls_.clear();
  scene.walls->findNear(robot.pose.position, from_middle + 2.0 * footprint.reach(), near_walls_);
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
