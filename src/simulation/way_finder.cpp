#include "social_crowd/simulation/way_finder.h"

#include <algorithm>

namespace crowd {
namespace {

/// Bounds grow in steps of this length [m], so that episodes of a scenario have the same.
constexpr double BOUNDS_STEP = 8.0;

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

/// Walls, obstacles at rest, and bounds around them, all agents and their goals.
FloorPlan floorOf(const World& world) {
  FloorPlan floor;
  floor.bounds.emplace();
  floor.walls = world.walls();
  for (const Obstacle& obstacle : world.obstacles()) {
    if (!obstacle.path.moves()) floor.obstacles.push_back({obstacle.path.position(0.0), obstacle.radius});
  }
  for (const Segment& wall : floor.walls) {
    includePoint(wall.from, *floor.bounds);
    includePoint(wall.to, *floor.bounds);
  }
  for (const FloorPlan::Disc& disc : floor.obstacles) includePoint(disc.centre, *floor.bounds);
  for (const Agent& agent : world.agents()) {
    includePoint(agent.pose.position, *floor.bounds);
    for (const Vector2& goal : agent.goals) includePoint(goal, *floor.bounds);
  }
  return floor;
}

double largestRadius(const World& world) {
  double radius = 0.0;
  for (const Agent& agent : world.agents()) radius = std::max(radius, agent.radius);
  return radius;
}

}  // namespace

void WayFinder::update(World& world) {
  const auto is_outside = [this](const Agent& agent) {
    return agent.isWalking() && !(contains(bounds_, agent.pose.position) && contains(bounds_, agent.goal()));
  };
  const bool has_left = is_needed_ && std::any_of(world.agents().begin(), world.agents().end(), is_outside);
  if (has_left || world.layoutChanges() != layout_changes_) adoptLayout(world);
  if (!is_needed_) return;
  agents_.resize(world.agents().size());
  paths_.resize(world.agents().size());
  for (const Agent& agent : world.agents()) {
    if (agent.isWalking()) lead(agent, world);
  }
  right_of_way_->update(world, paths_);
}

void WayFinder::adoptLayout(const World& world) {
  layout_changes_ = world.layoutChanges();
  const FloorPlan floor = floorOf(world);
  is_needed_ = !world.agents().empty() && (!floor.walls.empty() || !floor.obstacles.empty());
  agents_.clear();
  if (!is_needed_) return;
  bounds_ = *floor.bounds;
  const double radius = largestRadius(world);
  data_ = navigationData(floor, radius, RightOfWay::maxWidth(radius));
  comfortable_.emplace(data_->comfortable);
  tight_.emplace(data_->tight);
  right_of_way_.emplace(std::shared_ptr<const Passages>(data_, &data_->passages), radius);
}

void WayFinder::lead(const Agent& agent, World& world) {
  Way& way = agents_[agent.id];
  RemainingPath& path = paths_[agent.id];
  path.clear();
  world.setYielding(agent.id, false);
  if (!way.follower || way.follower->goal() != agent.goal()) {
    way.follower.emplace(agent.goal());
    way.is_tight = false;
  }
  const Vector2 next = nextPoint(agent, way);
  way.out_of_reach = way.follower->state() == PathFollower::State::UNREACHABLE;
  if (way.out_of_reach || next == agent.goal()) {
    world.clearWaypoint(agent.id);
  } else {
    world.setWaypoint(agent.id, next);
  }
  for (const Vector2& corner : way.follower->corners()) path.push_back(corner);
}

Vector2 WayFinder::nextPoint(const Agent& agent, Way& way) {
  if (!way.is_tight) {
    const Vector2 next = way.follower->next(agent.pose.position, *comfortable_);
    if (way.follower->state() == PathFollower::State::ON_THE_WAY) return next;
    way.is_tight = true;
    way.follower->replan();
  }
  return way.follower->next(agent.pose.position, *tight_);
}

}  // namespace crowd
