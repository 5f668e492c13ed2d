#include "social_crowd/simulation/way_finder.h"

#include <algorithm>
#include <cstdlib>

namespace crowd {
namespace {

/// Bounds grow in steps of this length [m], so that episodes of a scenario have the same.
constexpr double BOUNDS_STEP = 8.0;

constexpr double LANE_WIDTH = 2.4;    // of the floor beside a corner that is looked at [m]
constexpr double LANE_STEP = 0.2;     // [m]
constexpr double LANE_SHARE = 0.7;    // of this width, for the lane of those who turn left
constexpr double LANE_REACHED = 0.4;  // [m]

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
  if (!std::getenv("NOROW")) right_of_way_->update(world, paths_);
  if (!std::getenv("NODR")) deadlocks_.update(world);
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
    if (way.follower->state() == PathFollower::State::ON_THE_WAY) return keepRight(agent, next, way, *comfortable_);
    way.is_tight = true;
    way.follower->replan();
  }
  const Vector2 next = way.follower->next(agent.pose.position, *tight_);
  if (way.follower->state() == PathFollower::State::UNREACHABLE) return next;
  return keepRight(agent, next, way, *tight_);
}

/// Round a corner to the left, agents use the right half of the floor beside it, so that those who come from the other
/// side, and turn right there, pass on the inside.
Vector2 WayFinder::keepRight(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) {
  const Vector2& position = agent.pose.position;
  if (way.lane) {
    const Vector2 offset = way.lane->place - position;
    const bool is_passed = offset.dot(way.lane->forward) <= 0.0 || offset.norm() < LANE_REACHED;
    if (!is_passed && query.isStraight(position, way.lane->place)) return way.lane->place;
    way.lane.reset();
  }
  const Span<Vector2> corners = way.follower->corners();
  if (corners.size() < 2) return next;
  way.lane = laneAt(position, corners[0], corners[1], agent.radius, query);
  return way.lane ? way.lane->place : next;
}

std::optional<WayFinder::Lane> WayFinder::laneAt(const Vector2& position, const Vector2& corner, const Vector2& after,
                                                 double radius, NavigationMesh::Query& query) {
  const Vector2 before = (corner - position).normalized();
  const Vector2 behind = (after - corner).normalized();
  if (cross(before, behind) <= 0.0 || (corner - position).norm() < LANE_REACHED) return std::nullopt;
  const Vector2 forward = (before + behind).normalized();
  const Vector2 right(forward.y(), -forward.x());
  double width = 0.0;
  while (width < LANE_WIDTH && query.isStraight(corner, corner + (width + LANE_STEP) * right)) width += LANE_STEP;
  if (width < 2.0 * radius + LANE_STEP) return std::nullopt;
  const Vector2 place = corner + LANE_SHARE * width * right;
  if (!query.isStraight(position, place) || !query.isStraight(place, after)) return std::nullopt;
  return Lane{place, forward};
}

}  // namespace crowd
