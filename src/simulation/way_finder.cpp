#include "social_crowd/simulation/way_finder.h"

#include <algorithm>

namespace crowd {
namespace {

FloorPlan floorOf(const World& world) {
  FloorPlan floor;
  floor.walls = world.walls();
  for (const Obstacle& obstacle : world.obstacles()) {
    if (!obstacle.path.moves()) floor.obstacles.push_back({obstacle.path.position(0.0), obstacle.radius});
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
  if (world.layoutChanges() != layout_changes_) adoptLayout(world);
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
