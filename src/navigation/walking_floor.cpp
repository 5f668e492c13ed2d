#include "navigation/walking_floor.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "scenario/population_spec.h"

namespace crowd {
namespace {

/// Bounds grow in steps of this length [m], so that episodes of a scenario have the same.
constexpr double BOUNDS_STEP = 8.0;

/// Free floor beside an obstacle that stands alone, on which two agents pass each other [m].
double passingRoom(double radius) { return 4.0 * radius + 0.45; }
constexpr double LARGE_OBSTACLE = 1.0;  // radius from which ways lead round an obstacle that stands alone [m]

/// Whether agents of this radius can walk round an obstacle on both sides, one beside the other.
bool standsAlone(const FloorPlan::Disc& disc, const FloorPlan& floor, double radius) {
  const double room = passingRoom(radius);
  const auto is_near = [&](const FloorPlan::Disc& other) {
    return &other != &disc && (other.centre - disc.centre).norm() < disc.radius + other.radius + room;
  };
  const auto is_near_wall = [&](const Segment& wall) { return distanceTo(wall, disc.centre) < disc.radius + room; };
  return disc.radius <= LARGE_OBSTACLE && std::none_of(floor.obstacles.begin(), floor.obstacles.end(), is_near) &&
         std::none_of(floor.walls.begin(), floor.walls.end(), is_near_wall);
}

}  // namespace

void includePoint(const Vector2& point, FloorPlan::Bounds& bounds) {
  const Vector2 margin = Vector2::Constant(FloorPlan::MARGIN);
  const Vector2 low = ((point - margin) / BOUNDS_STEP).array().floor() * BOUNDS_STEP;
  const Vector2 high = ((point + margin) / BOUNDS_STEP).array().ceil() * BOUNDS_STEP;
  bounds.low = bounds.low.cwiseMin(low);
  bounds.high = bounds.high.cwiseMax(high);
}

bool contains(const FloorPlan::Bounds& bounds, const Vector2& point) {
  return (point.array() >= bounds.low.array()).all() && (point.array() <= bounds.high.array()).all();
}

FloorPlan walkingFloor(const World& world, double radius, const WorldChange& change) {
  FloorPlan floor;
  floor.bounds = FloorPlan::Bounds{Vector2::Constant(INFINITE), Vector2::Constant(-INFINITE)};
  floor.walls = change.walls != nullptr ? *change.walls : world.walls().list();
  for (const Obstacle& obstacle : change.obstacles != nullptr ? *change.obstacles : world.obstacles()) {
    if (!obstacle.path.moves()) floor.obstacles.push_back({obstacle.path.position(0.0), obstacle.radius});
  }
  std::vector<FloorPlan::Disc> to_walk_round;
  std::copy_if(floor.obstacles.begin(), floor.obstacles.end(), std::back_inserter(to_walk_round),
               [&](const FloorPlan::Disc& disc) {
                 world.stopRequest().throwIfMade();
                 return !standsAlone(disc, floor, radius);
               });
  floor.obstacles = to_walk_round;
  for (const Segment& wall : floor.walls) {
    includePoint(wall.from, *floor.bounds);
    includePoint(wall.to, *floor.bounds);
  }
  for (const FloorPlan::Disc& disc : floor.obstacles) includePoint(disc.centre, *floor.bounds);
  const auto include = [&](const Agent& agent) {
    includePoint(agent.pose.position, *floor.bounds);
    for (const Vector2& goal : agent.goals) includePoint(goal, *floor.bounds);
  };
  for (const Agent& agent : world.agents()) {
    if (change.agent == nullptr || agent.id != change.agent->id) include(agent);
  }
  if (change.agent != nullptr) include(*change.agent);
  // Those who left count, too: the floor of an episode does not shrink.
  const Eigen::AlignedBox2d& left = world.departed().places;
  if (!left.isEmpty()) {
    includePoint(left.min(), *floor.bounds);
    includePoint(left.max(), *floor.bounds);
  }
  return floor;
}

double largestRadius(const World& world, const WorldChange& change) {
  double radius = world.departed().largest_radius;
  if (change.agent != nullptr) radius = std::max(radius, change.agent->radius);
  for (const Agent& agent : world.agents()) radius = std::max(radius, agent.radius);
  return radius;
}

double largestSourceRadius(const Scene& scene) {
  double radius = 0.0;
  if (!scene.population) return radius;
  for (const SourceDescription& source : scene.population->sources) {
    radius = std::max(radius, source.agents.radius.high);
  }
  return radius;
}

std::vector<Segment> gateWalls(const Scene& scene) {
  std::vector<Segment> walls;
  if (!scene.population) return walls;
  for (const GateDescription& gate : scene.population->gates) walls.push_back(gate.wall);
  return walls;
}

bool openGates(const std::vector<Segment>& gates, FloorPlan& floor) {
  const auto is_gate = [&](const Segment& wall) {
    return std::any_of(gates.begin(), gates.end(),
                       [&](const Segment& gate) { return gate.from == wall.from && gate.to == wall.to; });
  };
  const auto closed = std::remove_if(floor.walls.begin(), floor.walls.end(), is_gate);
  const bool has_closed = closed != floor.walls.end();
  floor.walls.erase(closed, floor.walls.end());
  return has_closed;
}

}  // namespace crowd
