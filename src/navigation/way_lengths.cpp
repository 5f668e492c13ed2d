#include "navigation/way_lengths.h"

#include <algorithm>
#include <utility>

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

SizedFloor* WayLengths::floorFor(const World& world, const Vector2& from, const Vector2& to, double radius) {
  const double size = sizeOf(radius);
  if (layout_changes_ != world.layoutChanges() || !contains(bounds_, from) || !contains(bounds_, to)) floors_.clear();
  const auto found = floors_.find(size);
  if (found != floors_.end()) return found->second ? &*found->second : nullptr;
  FloorPlan plan = walkingFloor(world, size);
  if (floors_.empty()) {
    includePoint(from, *plan.bounds);
    includePoint(to, *plan.bounds);
    bounds_ = *plan.bounds;
    layout_changes_ = world.layoutChanges();
  }
  std::optional<SizedFloor> floor;
  plan.bounds = bounds_;
  if (hasBarriers(plan)) floor.emplace(std::move(plan), size, gates_, world.stopRequest());
  std::optional<SizedFloor>& kept = floors_.emplace(size, std::move(floor)).first->second;
  return kept ? &*kept : nullptr;
}

std::optional<WayLengths::Way> WayLengths::find(const World& world, const Vector2& from, const Vector2& to,
                                                double radius) {
  SizedFloor* const floor = floorFor(world, from, to, radius);
  if (floor == nullptr) return Way{Kind::FREE, (to - from).norm()};
  if (const auto path = floor->tight().findPath(from, to)) return Way{Kind::FREE, path->length};
  if (!floor->hasClosedGates()) return std::nullopt;
  const auto path = floor->open(world.stopRequest()).findPath(from, to);
  if (!path) return std::nullopt;
  return Way{Kind::GATES, path->length};
}

bool WayLengths::connects(const World& world, const Vector2& from, const Vector2& to, double radius) {
  SizedFloor* const floor = floorFor(world, from, to, radius);
  if (floor == nullptr) return true;
  NavigationMesh::Query& query = floor->hasClosedGates() ? floor->open(world.stopRequest()) : floor->tight();
  const auto component = query.component(from);
  return !component || component == query.component(to);
}

std::string WayLengths::problemOf(const World& world, const Vector2& from, const Vector2& goal, double radius) {
  const std::string cover = coverOf(world, goal, radius - goal_tolerance_);
  if (!cover.empty()) return "the goal " + placeText(goal) + " is in " + cover;
  if (find(world, from, goal, radius)) return "";
  if (!floorFor(world, from, goal, radius)->tight().component(from)) return "";
  return "the goal " + placeText(goal) + " cannot be reached from " + placeText(from) + " with a radius of " +
         toText(sizeOf(radius)) + " m";
}

void WayLengths::requireWay(const std::string& who, const World& world, const Vector2& from, const Vector2& goal,
                            double radius) {
  const std::string problem = problemOf(world, from, goal, radius);
  if (!problem.empty()) throw InputError(who + ": " + problem);
}

}  // namespace crowd
