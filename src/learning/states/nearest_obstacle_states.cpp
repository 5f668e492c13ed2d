#include "social_crowd/learning/states/nearest_obstacle_states.h"

#include <limits>
#include <utility>

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

std::vector<double> inRadians(std::vector<double> degrees) {
  for (double& limit : degrees) limit = limit == 180.0 ? PI : toRadians(limit);
  return degrees;
}

/// Returns the distance to the nearest rim [m] and a point in its direction, agent frame.
std::pair<double, Vector2> findNearest(const Perception& perception) {
  std::pair<double, Vector2> nearest(std::numeric_limits<double>::infinity(), Vector2::Zero());
  for (const Neighbour& neighbour : perception.neighbours) {
    const double distance = neighbour.position.norm() - neighbour.radius;
    if (distance < nearest.first) nearest = {distance, neighbour.position};
  }
  for (const Segment& wall : perception.walls) {
    const Vector2 point = nearestPoint(wall, Vector2::Zero());
    if (point.norm() < nearest.first) nearest = {point.norm(), point};
  }
  return nearest;
}

}  // namespace

NearestObstacleStates::NearestObstacleStates(const Parameters& parameters)
    : parameters_(parameters),
      goal_sectors_(parameters.goal_sectors),
      obstacle_sectors_(inRadians(parameters.obstacle_sectors)) {}

NearestObstacleStates::Situation NearestObstacleStates::describe(const Perception& perception) const {
  Situation situation;
  situation.goal_sector = goal_sectors_.indexOf(bearingOf(perception.self.goal));
  const auto [distance, where] = findNearest(perception);
  situation.distance_class = parameters_.distances.classOf(distance);
  if (situation.distance_class > 0) situation.obstacle_sector = obstacle_sectors_.indexOf(bearingOf(where));
  return situation;
}

Row NearestObstacleStates::rowOf(const Situation& situation) const {
  if (situation.distance_class == 0) return static_cast<Row>(situation.goal_sector);  // (3.2)
  const int obstacle_states = obstacle_sectors_.count() * DistanceClasses::COUNT;
  return static_cast<Row>((goal_sectors_.count() - 1) + situation.goal_sector * obstacle_states +
                          situation.obstacle_sector * DistanceClasses::COUNT + situation.distance_class);  // (3.3)
}

Row NearestObstacleStates::terminal() const {
  const int obstacle_states = obstacle_sectors_.count() * DistanceClasses::COUNT;
  return static_cast<Row>(goal_sectors_.count() * obstacle_states + goal_sectors_.count());  // (3.4)
}

NearestObstacleStates::Situation NearestObstacleStates::situationOf(Row row) const {
  const int code = static_cast<int>(row) - goal_sectors_.count();
  if (code < 0) return {static_cast<int>(row), 0, 0};
  const int obstacle_states = obstacle_sectors_.count() * DistanceClasses::COUNT;
  return {code / obstacle_states, code % obstacle_states / DistanceClasses::COUNT, code % DistanceClasses::COUNT + 1};
}

Row NearestObstacleStates::mirrored(Row row) const {
  if (row >= terminal()) return row;
  Situation situation = situationOf(row);
  situation.goal_sector = goal_sectors_.mirrored(situation.goal_sector);
  situation.obstacle_sector = obstacle_sectors_.mirrored(situation.obstacle_sector);
  return rowOf(situation);
}

std::vector<int> NearestObstacleStates::distanceClasses(Row row) const {
  if (row >= terminal()) return {};
  const int distance_class = situationOf(row).distance_class;
  return distance_class > 0 ? std::vector<int>{distance_class} : std::vector<int>();
}

std::vector<OccupiedSector> NearestObstacleStates::occupiedSectors(const Perception& perception) const {
  const Situation situation = describe(perception);
  if (situation.distance_class == 0) return {};
  return {{obstacle_sectors_.rightLimit(situation.obstacle_sector),
           obstacle_sectors_.leftLimit(situation.obstacle_sector), situation.distance_class}};
}

std::vector<double> NearestObstacleStates::distanceLimits() const {
  return {parameters_.distances.collision_radius, parameters_.distances.vision_radius};
}

std::string NearestObstacleStates::spec() const {
  std::string limits;
  for (const double limit : parameters_.obstacle_sectors) limits += (limits.empty() ? "" : ", ") + toText(limit);
  return std::string("{type: ") + TYPE + ", goal_sectors: " + std::to_string(parameters_.goal_sectors) +
         ", obstacle_sectors: [" + limits + "], collision_radius: " + toText(parameters_.distances.collision_radius) +
         ", vision_radius: " + toText(parameters_.distances.vision_radius) + "}";
}

}  // namespace crowd
