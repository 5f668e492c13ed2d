#include "navigation/way_finder.h"

#include <algorithm>
#include <array>
#include <utility>

namespace crowd {
namespace {

constexpr double LANE_WIDTH = 3.2;         // agents keep right where the floor is narrower, less their diameter [m]
constexpr double LANE_STEP = 0.2;          // of the measurement of the width [m]
constexpr double LANE_SHARE = 0.1;         // distance of the lane from the right side, as a share of the width
constexpr double LANE_MARGIN = 0.15;       // and its smallest value [m]
constexpr double LANE_LOOKAHEAD = 3.0;     // [m]
constexpr double LANE_REACHED = 0.4;       // [m]
constexpr double AIM_DISTANCE = 0.25;      // an agent aims at the same point until it has moved this far [m]
constexpr double SLOW_SHARE = 0.8;         // an agent below this share of its maximum speed is slowed down
constexpr double SPREAD_RATE = 1.0;        // at which it moves outwards in front of a corner [m/s]
constexpr double SPREAD_STEP = 0.5;        // at which its aim is chosen again [m]
constexpr double MAX_SPREAD = 8.0;         // [m]
constexpr double SPREAD_LOOKAHEAD = 10.0;  // [m]
constexpr double SPREAD_WIDTH = 6.0;       // of the floor beside the corner [m]

}  // namespace

void WayFinder::update(World& world) {
  const auto does_not_fit = [this](const Agent& agent) {
    const bool is_inside = contains(bounds_, agent.pose.position) && contains(bounds_, agent.goal());
    return agent.isWalking() && (agent.radius > radius_ || (is_needed_ && !is_inside));
  };
  const bool is_outgrown = std::any_of(world.agents().begin(), world.agents().end(), does_not_fit);
  if (is_outgrown || world.layoutChanges() != layout_changes_) adoptLayout(world);
  if (!is_needed_) return;
  ways_.follow(world.agents());
  paths_.follow(world.agents());
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (!agent.isWalking()) continue;
    world.stopRequest().throwIfMade();
    lead(world.walkingAgent(agent.id), ways_.nth(i), world);
    const Span<Vector2> corners = ways_.nth(i).follower->corners();
    paths_.nth(i).assign(corners.begin(), corners.end());
  }
  right_of_way_->update(world, paths_);
  deadlocks_.update(world, paths_);
  right_of_way_->formSingleFiles(world, deadlocks_);
}

void WayFinder::adoptLayout(World& world) {
  layout_changes_ = world.layoutChanges();
  radius_ = std::max(least_radius_, largestRadius(world));
  FloorPlan floor = walkingFloor(world, radius_);
  const bool was_needed = std::exchange(is_needed_, radius_ > 0.0 && hasBarriers(floor));
  ways_.clear();
  if (was_needed && !is_needed_) release(world);
  if (!is_needed_) return;
  bounds_ = *floor.bounds;
  data_ = navigationDataOf(floor, radius_, world.stopRequest());
  comfortable_.emplace(data_->comfortable);
  tight_.emplace(data_->tight);
  right_of_way_.emplace(std::shared_ptr<const Passages>(data_, &data_->passages), radius_);
  open_.reset();
  open_floor_.reset();
  if (openGates(gates_, floor)) open_floor_ = std::move(floor);
}

void WayFinder::release(World& world) {
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    Agent& walking = world.walkingAgent(agent.id);
    walking.yielding = false;
    walking.clearWaypoint();
  }
}

void WayFinder::lead(Agent& agent, Way& way, const World& world) {
  const bool waits = agent.yielding || agent.held;
  agent.yielding = false;
  if (!way.follower || way.follower->goal() != agent.goal()) {
    way = Way();
    way.follower.emplace(agent.goal());
  }
  if (!waits && agent.velocity.norm() < SLOW_SHARE * agent.max_speed) {
    way.spread = std::min(MAX_SPREAD, way.spread + SPREAD_RATE * world.tickDuration());
  }
  const Vector2 next = nextPoint(agent, way, world.stopRequest());
  const bool is_led = way.follower->state() == PathFollower::State::ON_THE_WAY;
  // An agent in a wall or an obstacle, as in a ghost world, is not led, but may walk out of it.
  way.out_of_reach = !is_led && tight_->component(agent.pose.position).has_value();
  const bool sees_goal = way.out_of_reach && world.walls().index().isClear(agent.pose.position, agent.goal(), 0.0);
  if (way.out_of_reach && !sees_goal) agent.yielding = true;
  if (!is_led || next == agent.goal()) {
    agent.clearWaypoint();
  } else {
    agent.setWaypoint(next);
  }
}

Vector2 WayFinder::nextPoint(const Agent& agent, Way& way, const StopRequest& stop) {
  const Vector2& position = agent.pose.position;
  if (way.floor == Floor::OPEN && areConnected(position, agent.goal())) {
    way.floor = Floor::TIGHT;
    way.follower->replan();
  }
  if (way.floor == Floor::COMFORTABLE) {
    Vector2 next = way.follower->next(position, *comfortable_);
    if (way.follower->state() == PathFollower::State::ON_THE_WAY) return keepRight(agent, next, way, *comfortable_);
    way.floor = Floor::TIGHT;
    way.follower->replan();
  }
  if (way.floor == Floor::TIGHT) {
    Vector2 next = way.follower->next(position, *tight_);
    if (way.follower->state() != PathFollower::State::UNREACHABLE) return keepRight(agent, next, way, *tight_);
    if (!open_floor_) return next;
    way.floor = Floor::OPEN;
    way.follower->replan();
  }
  if (!open_) open_.emplace(navigationDataOf(*open_floor_, radius_, stop)->tight);
  return way.follower->next(position, *open_);
}

bool WayFinder::areConnected(const Vector2& from, const Vector2& to) {
  const auto component = tight_->component(from);
  return component && component == tight_->component(to);
}

/// In corridors agents walk on the right, so that agents in opposite directions do not meet head-on.
Vector2 WayFinder::keepRight(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const {
  const Vector2& position = agent.pose.position;
  if (way.aim && way.aim->corner != next) way.spread = 0.0;
  bool is_due = !way.aim || way.aim->corner != next || (position - way.aim->from).norm() >= AIM_DISTANCE;
  if (way.aim && way.spread >= way.aim->spread + SPREAD_STEP) {
    is_due = true;
    way.lane.reset();
  }
  if (way.lane) {
    const Vector2 offset = way.lane->place - position;
    const bool is_passed = offset.dot(way.lane->forward) <= 0.0 || offset.norm() < LANE_REACHED;
    is_due = is_due || is_passed;
    if (is_passed || (is_due && !query.isStraight(position, way.lane->place))) way.lane.reset();
  }
  if (is_due) {
    way.aim = Aim{way.lane ? way.lane->place : chooseAim(agent, next, way, query), next, position, way.spread};
  }
  return way.aim->point;
}

/// Starts a lane if a corner is near.
Vector2 WayFinder::chooseAim(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const {
  const Vector2& position = agent.pose.position;
  const Span<Vector2> corners = way.follower->corners();
  const double distance = (next - position).norm();
  if (distance < LANE_REACHED || (corners.size() < 2 && distance < LANE_LOOKAHEAD)) return next;
  const Vector2 direction = (next - position) / distance;
  const auto past_corner = [&] { return Vector2((direction + (corners[1] - next).normalized()).normalized()); };
  if (const auto place = placeOutside(position, next, way, query)) {
    way.lane = Lane{*place, past_corner()};
    return *place;
  }
  const bool is_corner = distance < LANE_LOOKAHEAD;
  const Vector2 forward = is_corner ? past_corner() : direction;
  const Vector2 ahead = position + std::min(distance, LANE_LOOKAHEAD) * direction;
  if (!isCorridor(position, ahead, direction, agent.radius)) return next;
  Vector2 place = laneBeside(ahead, forward, agent.radius);
  if (place == ahead || !query.isStraight(position, place)) return next;
  if (is_corner) way.lane = Lane{place, forward};
  return place;
}

/// Where an agent that was slowed down passes a corner with a wide floor beside it: not at the corner, where the others
/// are, but farther outside. The longer it was slowed down, the farther.
std::optional<Vector2> WayFinder::placeOutside(const Vector2& position, const Vector2& next, const Way& way,
                                               NavigationMesh::Query& query) {
  const Span<Vector2> corners = way.follower->corners();
  const double distance = (next - position).norm();
  if (corners.size() < 2 || way.spread < SPREAD_STEP || distance > SPREAD_LOOKAHEAD) return std::nullopt;
  const Vector2 direction = (next - position) / distance;
  const Vector2 beyond = pointAlong({corners.begin() + 1, corners.size() - 1}, next, SPREAD_WIDTH);
  const Vector2 outward = (direction - (beyond - next).normalized()).normalized();
  // The floor must be wide on both sides of the corner: this is not so at a door.
  const Vector2 wide = next + SPREAD_WIDTH * outward;
  if (!query.isStraight(next, wide) || !query.isStraight(wide, beyond)) return std::nullopt;
  const Vector2 place = next + way.spread * outward;
  const bool is_free = query.isStraight(position, place) && query.isStraight(place, beyond);
  return is_free ? std::optional<Vector2>(place) : std::nullopt;
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

/// The place to the right, on the line across the floor, where agents in this direction pass.
Vector2 WayFinder::laneBeside(const Vector2& place, const Vector2& forward, double radius) const {
  const Sides room = floorBeside(place, forward, radius);
  if (room.width() > LANE_WIDTH || room.width() < 2.0 * radius + LANE_STEP) return place;
  const double shift = room.right - std::max(LANE_MARGIN, LANE_SHARE * room.width());
  return shift > 0.0 ? Vector2(place + shift * Vector2(forward.y(), -forward.x())) : place;
}

}  // namespace crowd
