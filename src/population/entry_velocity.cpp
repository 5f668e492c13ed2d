#include "population/entry_velocity.h"

#include <algorithm>
#include <array>

#include "geometry/closest_points.h"
#include "scenario/scenario.h"

namespace crowd {
namespace {

constexpr std::array<double, 4> SPEED_SHARES = {1.0, 0.75, 0.5, 0.25};

/// Whether a disc that moves along `way` keeps DRAWN_GAP from one that moves along `other_way`.
bool isClear(const Segment& way, double radius, const Segment& other_way, double other_radius) {
  const ClosestPoints points = closestPoints(way, other_way);
  return (points.of_first - points.of_second).norm() > radius + other_radius + DRAWN_GAP;
}

/// Where a body goes in the next tick, and until it stands afterwards.
Segment stoppingPath(const Vector2& place, const Vector2& velocity, const World& world) {
  return {place, place + world.tickDuration() * velocity + world.motion().stoppingWay(velocity)};
}

bool canStop(const AgentStart& start, const Vector2& velocity, const World& world) {
  const Segment way = stoppingPath(start.position, velocity, world);
  if (!world.walls().index().isClear(way.from, way.to, start.radius + DRAWN_GAP)) return false;
  const auto leaves_way = [&](const Agent& other) {
    const Segment its_way = stoppingPath(other.pose.position, other.velocity, world);
    return !other.isPresent() || isClear(way, start.radius, its_way, other.radius);
  };
  const auto is_beside = [&](const Obstacle& obstacle) {
    if (!obstacle.path.isPresent(world.time())) return true;
    const ObstaclePath::Motion motion = obstacle.path.at(world.time());
    const double time = start.walkingSpeed() / world.motion().braking + world.tickDuration();
    const Segment its_way{motion.position, motion.position + time * motion.velocity};
    return isClear(way, start.radius, its_way, obstacle.radius);
  };
  return std::all_of(world.agents().begin(), world.agents().end(), leaves_way) &&
         std::all_of(world.obstacles().begin(), world.obstacles().end(), is_beside) &&
         !world.robots().isAnyWithin(start.radius + (way.to - way.from).norm() + DRAWN_GAP, way.from);
}

}  // namespace

Vector2 entryVelocity(const AgentStart& start, const World& world) {
  const Vector2& goal = start.goals.front();
  const bool sees_goal = world.walls().index().isClear(start.position, goal, 0.0);
  if (!world.motion().areOn() || start.reaction_time > 0.0 || !sees_goal || goal == start.position) {
    return Vector2::Zero();
  }
  const Vector2 wanted = start.walkingSpeed() * (goal - start.position).normalized();
  for (const double share : SPEED_SHARES) {
    if (canStop(start, share * wanted, world)) return share * wanted;
  }
  return Vector2::Zero();
}

}  // namespace crowd
