#include "population/place_picker.h"

#include <algorithm>
#include <limits>

#include "geometry/impact.h"
#include "scenario/region_geometry.h"
#include "scenario/route_reach.h"

namespace crowd {

PlacePicker::PlacePicker(const Scene& scene)
    : goal_tolerance_(scene.goal_tolerance), free_space_(scene.free_space), map_(scene.map) {}

bool PlacePicker::fits(const Vector2& place, double radius, const World& world) const {
  if (world.walls().index().isAnyWithin(place, radius - TOUCH_TOLERANCE)) return false;
  if (map_ != nullptr && !map_->isFree(CellFrame(*map_).cellAt(place))) return false;
  const auto overlaps = [&](const Obstacle& obstacle) {
    return !obstacle.path.moves() && (obstacle.path.position(0.0) - place).norm() < radius + obstacle.radius;
  };
  return std::none_of(world.obstacles().begin(), world.obstacles().end(), overlaps);
}

std::uint32_t PlacePicker::componentNear(const Vector2& place, double radius) const {
  constexpr int DIRECTIONS = 8;
  std::uint32_t component = free_space_->component(place);
  for (int i = 0; i < DIRECTIONS && component == FreeSpace::NONE; ++i) {
    component = free_space_->component(place + radius * unitVector(2.0 * PI * i / DIRECTIONS));
  }
  return component;
}

Vector2 PlacePicker::drawGoal(const Region& region, const Vector2& from, double radius, KeyedRandom random,
                              const World& world, const Reach& can_reach) const {
  if (region.isFixed()) return region.first;
  const std::uint32_t home = free_space_ ? componentNear(from, radius) : FreeSpace::NONE;
  std::optional<Vector2> fitting;  // the first one, although out of reach
  Vector2 goal = from;
  for (int tries = 0; tries < MAX_TRIES; ++tries) {
    goal = region.draw(random, free_space_.get());
    if ((goal - from).norm() <= goal_tolerance_ || !fits(goal, radius, world)) continue;
    if (!fitting) fitting = goal;
    const bool is_reachable = home == FreeSpace::NONE || free_space_->component(goal) == home;
    if (is_reachable && can_reach(from, goal, radius)) return goal;
  }
  return fitting.value_or(goal);
}

std::optional<Vector2> PlacePicker::drawStart(const Region& region, double radius, KeyedRandom random,
                                              const World& world) const {
  const int count = region.isFixed() ? 1 : START_TRIES;
  const double gap = region.isFixed() ? 0.0 : DRAWN_GAP;
  for (int tries = 0; tries < count; ++tries) {
    const Vector2 place = region.draw(random, free_space_.get());
    if (world.blockerAt(place, radius + gap).empty() && (region.isFixed() || fits(place, radius, world))) return place;
  }
  return std::nullopt;
}

bool PlacePicker::connects(const Vector2& place, const AgentGroup& group,
                           const PopulationDescription& population) const {
  if (group.position.kind != Region::Kind::FREE) return true;
  if (group.route) return connectsRoute(*free_space_, population, *group.route, place);
  const std::uint32_t home = free_space_->component(place);
  return std::all_of(group.goals.begin(), group.goals.end(), [&](const Region& goal) {
    const std::uint32_t component = goal.isFixed() ? free_space_->component(goal.first) : home;
    return component == home || component == FreeSpace::NONE;
  });
}

Vector2 PlacePicker::nearestIn(const Region& area, const Vector2& from, double radius, const World& world) const {
  const Region inner = shrink(area, std::max(radius, goal_tolerance_));
  Vector2 best = nearestPoint(inner, from);
  if (fits(best, radius, world)) return best;
  double least = std::numeric_limits<double>::infinity();
  for (const Vector2& point : gridPoints(area, std::max(0.1, 0.5 * radius))) {
    const double distance = (point - from).squaredNorm();
    if (distance >= least || !fits(point, radius, world)) continue;
    best = point;
    least = distance;
  }
  return best;
}

}  // namespace crowd
