#include "social_crowd/simulation/way_finder.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace crowd {
namespace {

/// Bounds grow in steps of this length [m], so that episodes of a scenario have the same.
constexpr double BOUNDS_STEP = 8.0;

constexpr double LARGE_OBSTACLE = 1.0;  // radius from which ways lead round an obstacle that stands alone [m]

constexpr double LANE_WIDTH = 3.2;      // agents keep right where the floor is narrower, less their diameter [m]
constexpr double LANE_STEP = 0.2;       // of the measurement of the width [m]
constexpr double LANE_SHARE = 0.1;      // distance of the lane from the right side, as a share of the width
constexpr double LANE_MARGIN = 0.15;    // and its smallest value [m]
constexpr double LANE_LOOKAHEAD = 3.0;  // [m]
constexpr double LANE_REACHED = 0.4;    // [m]
constexpr double AIM_DISTANCE = 0.25;   // an agent aims at the same point until it has moved this far [m]

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

/// Whether agents of this radius can walk round an obstacle on both sides, one beside the other.
bool standsAlone(const FloorPlan::Disc& disc, const FloorPlan& floor, double radius) {
  const double room = RightOfWay::maxWidth(radius);
  const auto is_near = [&](const FloorPlan::Disc& other) {
    return &other != &disc && (other.centre - disc.centre).norm() < disc.radius + other.radius + room;
  };
  const auto is_near_wall = [&](const Segment& wall) { return distanceTo(wall, disc.centre) < disc.radius + room; };
  return disc.radius <= LARGE_OBSTACLE && std::none_of(floor.obstacles.begin(), floor.obstacles.end(), is_near) &&
         std::none_of(floor.walls.begin(), floor.walls.end(), is_near_wall);
}

/// Walls, obstacles at rest, and bounds around them, all agents and their goals. Small obstacles that stand alone are
/// left to the learners, which walk round them with shorter paths.
FloorPlan floorOf(const World& world, double radius) {
  FloorPlan floor;
  floor.bounds.emplace();
  floor.walls = world.walls();
  for (const Obstacle& obstacle : world.obstacles()) {
    if (!obstacle.path.moves()) floor.obstacles.push_back({obstacle.path.position(0.0), obstacle.radius});
  }
  std::vector<FloorPlan::Disc> to_walk_round;
  std::copy_if(floor.obstacles.begin(), floor.obstacles.end(), std::back_inserter(to_walk_round),
               [&](const FloorPlan::Disc& disc) { return !standsAlone(disc, floor, radius); });
  floor.obstacles = to_walk_round;
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
  deadlocks_.update(world, paths_);
}

void WayFinder::adoptLayout(const World& world) {
  layout_changes_ = world.layoutChanges();
  const FloorPlan floor = floorOf(world, largestRadius(world));
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
  const Span<Vector2> corners = way.follower->corners();
  path.assign(corners.begin(), corners.end());
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

/// In corridors agents walk on the right, so that those who walk in opposite directions do not meet head-on.
Vector2 WayFinder::keepRight(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const {
  const Vector2& position = agent.pose.position;
  bool is_due = !way.aim || way.aim->corner != next || (position - way.aim->from).norm() >= AIM_DISTANCE;
  if (way.lane) {
    const Vector2 offset = way.lane->place - position;
    const bool is_passed = offset.dot(way.lane->forward) <= 0.0 || offset.norm() < LANE_REACHED;
    is_due = is_due || is_passed;
    if (is_passed || (is_due && !query.isStraight(position, way.lane->place))) way.lane.reset();
  }
  if (is_due) way.aim = Aim{way.lane ? way.lane->place : chooseAim(agent, next, way, query), next, position};
  return way.aim->point;
}

/// Starts a lane if a corner is near.
Vector2 WayFinder::chooseAim(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const {
  const Vector2& position = agent.pose.position;
  const Span<Vector2> corners = way.follower->corners();
  const double distance = (next - position).norm();
  if (distance < LANE_REACHED || (corners.size() < 2 && distance < LANE_LOOKAHEAD)) return next;
  const Vector2 direction = (next - position) / distance;
  const bool is_corner = distance < LANE_LOOKAHEAD;
  const Vector2 forward = is_corner ? Vector2((direction + (corners[1] - next).normalized()).normalized()) : direction;
  const Vector2 ahead = position + std::min(distance, LANE_LOOKAHEAD) * direction;
  if (!isCorridor(position, ahead, direction, agent.radius)) return next;
  const Vector2 place = laneBeside(ahead, forward, agent.radius);
  if (place == ahead || !query.isStraight(position, place)) return next;
  if (is_corner) way.lane = Lane{place, forward};
  return place;
}

/// Whether the floor is bounded on both sides all along this line.
bool WayFinder::isCorridor(const Vector2& from, const Vector2& to, const Vector2& forward, double radius) const {
  constexpr std::array<double, 4> SHARES = {0.0, 0.33, 0.67, 1.0};
  return std::all_of(SHARES.begin(), SHARES.end(), [&](double share) {
    return floorBeside(from + share * (to - from), forward, radius).width() < LANE_WIDTH;
  });
}

WayFinder::Sides WayFinder::floorBeside(const Vector2& place, const Vector2& forward, double radius) const {
  const Vector2 right(forward.y(), -forward.x());
  const auto room = [&](const Vector2& side, double limit) {
    double width = 0.0;
    while (width < limit && data_->passages.fits(place + (width + LANE_STEP) * side, radius)) width += LANE_STEP;
    return width;
  };
  // Wider floor is not measured to the end.
  const double left = room(-right, LANE_WIDTH);
  return {left, room(right, LANE_WIDTH + LANE_STEP - left)};
}

/// The place to the right, on the line across the floor, where those who walk in this direction pass.
Vector2 WayFinder::laneBeside(const Vector2& place, const Vector2& forward, double radius) const {
  const Sides room = floorBeside(place, forward, radius);
  if (room.width() > LANE_WIDTH || room.width() < 2.0 * radius + LANE_STEP) return place;
  const double shift = room.right - std::max(LANE_MARGIN, LANE_SHARE * room.width());
  return shift > 0.0 ? Vector2(place + shift * Vector2(forward.y(), -forward.x())) : place;
}

}  // namespace crowd
