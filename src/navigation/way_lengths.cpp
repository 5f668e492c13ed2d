#include "navigation/way_lengths.h"

#include <algorithm>

#include "common/text/numbers.h"
#include "scenario/region_geometry.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// What keeps an agent farther from a place than the goal tolerance; empty if nothing does.
std::string coverOf(const World& world, const Vector2& place, double distance) {
  if (distance <= 0.0) return "";
  if (world.walls().index().isAnyWithin(place, distance)) return "a wall";
  const auto covers = [&](const Obstacle& obstacle) {
    return !obstacle.path.moves() && (obstacle.path.position(0.0) - place).norm() < obstacle.radius + distance;
  };
  const auto found = std::find_if(world.obstacles().begin(), world.obstacles().end(), covers);
  if (found == world.obstacles().end()) return "";
  return "obstacle " + std::to_string(found - world.obstacles().begin());
}

}  // namespace

WayLengths::Floor& WayLengths::floorFor(const World& world, const Vector2& from, const Vector2& to, double radius,
                                        bool opened) {
  std::optional<Floor>& kept = opened ? opened_ : present_;
  const double largest = std::max({radius, least_radius_, largestRadius(world)});
  if (kept && kept->layout_changes == world.layoutChanges() && kept->radius == largest &&
      contains(kept->bounds, from) && contains(kept->bounds, to)) {
    return *kept;
  }
  kept.reset();
  FloorPlan plan = walkingFloor(world, largest);
  includePoint(from, *plan.bounds);
  includePoint(to, *plan.bounds);
  Floor floor;
  floor.layout_changes = world.layoutChanges();
  floor.radius = largest;
  floor.bounds = *plan.bounds;
  floor.has_barriers = hasBarriers(plan);
  FloorPlan without_gates = plan;
  floor.has_closed_gates = openGates(gates_, without_gates);
  if (floor.has_barriers) {
    floor.query.emplace(navigationData(opened ? without_gates : plan, largest, world.stopRequest())->tight);
  }
  return kept.emplace(std::move(floor));
}

std::optional<WayLengths::Way> WayLengths::find(const World& world, const Vector2& from, const Vector2& to,
                                                double radius) {
  Floor& present = floorFor(world, from, to, radius, false);
  if (!present.has_barriers) return Way{Kind::FREE, (to - from).norm()};
  if (const auto path = present.query->findPath(from, to)) return Way{Kind::FREE, path->length};
  if (!present.has_closed_gates) return std::nullopt;
  const auto path = floorFor(world, from, to, radius, true).query->findPath(from, to);
  if (!path) return std::nullopt;
  return Way{Kind::GATES, path->length};
}

std::string WayLengths::problemOf(const World& world, const Vector2& from, const Vector2& goal, double radius) {
  const std::string cover = coverOf(world, goal, radius - goal_tolerance_);
  if (!cover.empty()) return "the goal " + placeText(goal) + " is in " + cover;
  if (find(world, from, goal, radius) || !present_->query->component(from)) return "";
  return "the goal " + placeText(goal) + " cannot be reached from " + placeText(from) + " with a radius of " +
         toText(present_->radius) + " m";
}

void WayLengths::requireWay(const std::string& who, const World& world, const Vector2& from, const Vector2& goal,
                            double radius) {
  const std::string problem = problemOf(world, from, goal, radius);
  if (!problem.empty()) throw InputError(who + ": " + problem);
}

}  // namespace crowd
