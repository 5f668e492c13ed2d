#include "navigation/way_finder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace crowd {
namespace {

constexpr double LANE_WIDTH = 3.2;      // agents keep right where the floor is narrower, less their diameter [m]
constexpr double LANE_ROOM = 0.2;       // two lanes are wider than two bodies by this [m]
constexpr double LANE_SHARE = 0.1;      // distance of the lane from the right side, as a share of the width
constexpr double LANE_MARGIN = 0.15;    // and its smallest value [m]
constexpr double LANE_LOOKAHEAD = 3.0;  // [m]
constexpr double LANE_REACHED = 0.4;    // [m]
constexpr double AIM_DISTANCE = 0.25;   // an agent aims at the same point until it has moved this far [m]
constexpr double WAY_TIME = 2.0;        // after which an agent compares its way with others [s]
constexpr double FAILED_TIME = 12.0;    // after which it searches again for a way round a crowd if there was none [s]
constexpr unsigned WAY_GROUPS = 20;     // of agents that do so at different times
constexpr double LEAST_DELAY = 4.0;     // for which it does [s]
constexpr double DELAY_SHARE = 0.8;     // of a delay that will be there when it arrives
constexpr double LEAST_GAIN = 4.0;      // for which it takes another way [s]
constexpr double OUTSIDE_WIDTH = 9.0;   // of the floor beside a corner on which agents pass it [m]
constexpr double CROWD_RADIUS = 0.75;   // of the crowd that another way leads round [m]

}  // namespace

void WayFinder::findWays(World& world) {
  if (!finds_ways_) return leadGroups(world);
  const auto does_not_fit = [this](const Agent& agent) {
    const bool is_inside = contains(bounds_, agent.pose.position) && contains(bounds_, agent.goal());
    return agent.isWalking() && (sizeOf(agent.radius) > radius_ || (is_needed_ && !is_inside));
  };
  const bool is_outgrown = std::any_of(world.agents().begin(), world.agents().end(), does_not_fit);
  if (is_outgrown || world.layoutChanges() != layout_changes_) adoptLayout(world);
  if (!is_needed_) return leadGroups(world);
  ways_.follow(world.agents());
  paths_.follow(world.agents());
  groups_.update(world, paths_, ruler_.get());
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (!agent.isWalking()) continue;
    world.stopRequest().throwIfMade();
    SizedFloor& floor = floorOf(agent, world);
    reconsider(agent, ways_.nth(i), floor, world);
    lead(world.walkingAgent(agent.id), ways_.nth(i), floor, world);
    const Span<Vector2> corners = ways_.nth(i).follower->corners();
    paths_.nth(i).assign(corners.begin(), corners.end());
  }
  congestion_.update(world, paths_);
  turns_->update(world, paths_);
  deadlocks_.update(world, paths_, congestion_);
}

void WayFinder::adoptLayout(World& world) {
  layout_changes_ = world.layoutChanges();
  radius_ = sizeOf(std::max(least_radius_, largestRadius(world)));
  const FloorPlan floor = walkingFloor(world, radius_);
  const bool was_needed = std::exchange(is_needed_, radius_ > 0.0 && hasBarriers(floor));
  ways_.clear();
  floors_.clear();
  if (was_needed && !is_needed_) release(world);
  if (!is_needed_) return;
  bounds_ = *floor.bounds;
  ruler_ = floorRuler(floor, radius_, world.stopRequest());
  turns_.emplace(ruler_);
}

SizedFloor& WayFinder::floorOf(const Agent& agent, const World& world) {
  const double size = sizeOf(agent.radius);
  const auto found = floors_.find(size);
  if (found != floors_.end()) return found->second;
  FloorPlan floor = walkingFloor(world, size);
  floor.bounds = bounds_;
  return floors_.try_emplace(size, std::move(floor), size, gates_, world.stopRequest()).first->second;
}

/// Where there is nothing to walk round.
void WayFinder::leadGroups(World& world) {
  if (!world.hasGroups()) return;
  groups_.update(world, {}, nullptr);
  if (groups_.empty()) return;
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking() || agent.group == NO_GROUP) continue;
    const std::optional<Vector2> aim = groups_.aimOf(agent, agent.goal());
    aim ? world.walkingAgent(agent.id).setWaypoint(*aim) : world.walkingAgent(agent.id).clearWaypoint();
  }
}

void WayFinder::giveUp(World& world) {
  finds_ways_ = false;
  release(world);
}

void WayFinder::release(World& world) {
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    Agent& walking = world.walkingAgent(agent.id);
    walking.yielding = false;
    walking.clearWaypoint();
  }
}

void WayFinder::lead(Agent& agent, Way& way, SizedFloor& floor, const World& world) {
  agent.yielding = false;
  if (!way.follower || way.follower->goal() != agent.goal()) {
    way = Way();
    way.follower.emplace(agent.goal());
    way.search_time = world.time() + WAY_TIME * (agent.id % WAY_GROUPS) / double{WAY_GROUPS};
  }
  Vector2 next = nextPoint(agent, way, floor, world.stopRequest());
  const bool is_led = way.follower->state() != PathFollower::State::UNREACHABLE;
  const bool has_mates = is_led && agent.group != NO_GROUP;
  const std::optional<Vector2> aim = has_mates ? groups_.aimOf(agent, next) : std::nullopt;
  if (aim && floor.tight().isStraight(agent.pose.position, *aim)) next = *aim;
  // An agent in a wall or an obstacle, as in a ghost world, is not led, but may walk out of it.
  way.out_of_reach = !is_led && floor.tight().component(agent.pose.position).has_value();
  const bool sees_goal = way.out_of_reach && world.walls().index().isClear(agent.pose.position, agent.goal(), 0.0);
  if (way.out_of_reach && !sees_goal) agent.yielding = true;
  if (!is_led || next == agent.goal()) {
    agent.clearWaypoint();
  } else {
    agent.setWaypoint(next);
  }
}

/// An agent that will be held up by a crowd on its way takes another one, or passes the next corner farther outside, if
/// that saves time. Agents do so at different times, so that they do not all choose the same one.
void WayFinder::reconsider(const Agent& agent, Way& way, SizedFloor& floor, const World& world) {
  const bool is_led = way.follower && way.follower->goal() == agent.goal() && way.floor != Floor::OPEN;
  if (!is_led || agent.at_goal || agent.isHeld() || world.time() < way.search_time) return;
  way.search_time = world.time() + WAY_TIME;
  const Vector2& place = agent.pose.position;
  const Span<Vector2> corners = way.follower->corners();
  const CongestionMap::Delay delay = congestion_.delayOn(place, corners, agent.max_speed);
  if (delay.total < LEAST_DELAY) return;
  const double max_time = timeOf(agent, lengthOf(corners, place), delay.total) - LEAST_GAIN;
  NavigationMesh::Query& query = way.floor == Floor::COMFORTABLE ? floor.comfortable() : floor.tight();
  if (corners.size() > 1 && !way.lane && passOutside(agent, max_time, way, query)) return;
  if (world.time() < way.around_time) return;
  std::optional<Path> other =
      query.findWayAround({delay.place, CROWD_RADIUS}, place, agent.goal(), max_time * agent.max_speed);
  if (other && timeOf(agent, {other->corners.data(), other->corners.size()}) <= max_time) {
    way.follower->follow(std::move(*other));
  } else {
    way.around_time = world.time() + FAILED_TIME;
  }
}

/// The time that a way takes [s].
double WayFinder::timeOf(const Agent& agent, Span<Vector2> corners) const {
  const Vector2& place = agent.pose.position;
  return timeOf(agent, lengthOf(corners, place), congestion_.delayOn(place, corners, agent.max_speed).total);
}

/// The same of a way of this length [m], with this delay [s].
double WayFinder::timeOf(const Agent& agent, double length, double delay) {
  return length / agent.max_speed + DELAY_SHARE * delay;
}

/// Lets an agent pass the next corner where that takes the least time, and at most this time [s]. Returns false if
/// there is no such place.
bool WayFinder::passOutside(const Agent& agent, double max_time, Way& way, NavigationMesh::Query& query) const {
  const Vector2& position = agent.pose.position;
  const Span<Vector2> corners = way.follower->corners();
  const Vector2 before = (corners[0] - position).normalized();
  const Vector2 behind = (corners[1] - corners[0]).normalized();
  const Vector2 beyond = pointAlong({corners.begin() + 1, corners.size() - 1}, corners[0], OUTSIDE_WIDTH);
  std::vector<Vector2> way_outside(corners.begin(), corners.end());
  double least = max_time;
  bool found = false;
  for (double distance = CongestionMap::CELL; distance <= OUTSIDE_WIDTH; distance += CongestionMap::CELL) {
    const Vector2 place = corners[0] + distance * (before - behind).normalized();
    if (!query.isStraight(position, place) || !query.isStraight(place, beyond)) break;
    way_outside[0] = place;
    const double time = timeOf(agent, {way_outside.data(), way_outside.size()});
    if (time > least) continue;
    least = time;
    found = true;
    way.lane = Lane{place, (before + behind).normalized()};
    way.aim = Aim{place, corners[0], position};
  }
  return found;
}

Vector2 WayFinder::nextPoint(const Agent& agent, Way& way, SizedFloor& floor, const StopRequest& stop) const {
  const Vector2& position = agent.pose.position;
  if (way.floor == Floor::OPEN) {
    const auto component = floor.tight().component(position);
    if (component && component == floor.tight().component(agent.goal())) {
      way.floor = Floor::TIGHT;
      way.follower->replan();
    }
  }
  if (way.floor == Floor::COMFORTABLE) {
    Vector2 next = way.follower->next(position, floor.comfortable());
    if (way.follower->state() == PathFollower::State::ON_THE_WAY) {
      return keepRight(agent, next, way, floor.comfortable());
    }
    way.floor = Floor::TIGHT;
    way.follower->recheck();
  }
  if (way.floor == Floor::TIGHT) {
    Vector2 next = way.follower->next(position, floor.tight());
    if (way.follower->state() != PathFollower::State::UNREACHABLE) return keepRight(agent, next, way, floor.tight());
    if (!floor.hasClosedGates()) return next;
    way.floor = Floor::OPEN;
    way.follower->replan();
  }
  return way.follower->next(position, floor.open(stop));
}

/// In corridors agents walk on the right, so that agents in opposite directions do not meet head-on.
Vector2 WayFinder::keepRight(const Agent& agent, const Vector2& next, Way& way, NavigationMesh::Query& query) const {
  const Vector2& position = agent.pose.position;
  bool is_due = !way.aim || way.aim->corner != next || (position - way.aim->from).norm() >= AIM_DISTANCE;
  if (way.lane) {
    const Vector2 offset = way.lane->place - position;
    const bool is_passed = offset.dot(way.lane->forward) <= 0.0 || offset.norm() < LANE_REACHED;
    is_due = is_due || is_passed;
    if (is_passed || (is_due && !query.isStraight(position, way.lane->place))) way.lane.reset();
  }
  if (is_due) {
    way.aim = Aim{way.lane ? way.lane->place : chooseAim(agent, next, way, query), next, position};
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
  const bool is_corner = distance < LANE_LOOKAHEAD;
  const Vector2 forward = is_corner ? Vector2((direction + (corners[1] - next).normalized()).normalized()) : direction;
  const Vector2 ahead = position + std::min(distance, LANE_LOOKAHEAD) * direction;
  if (!isCorridor(position, ahead, direction, agent.radius)) return next;
  Vector2 place = laneBeside(ahead, forward, agent.radius);
  if (place == ahead || !query.isStraight(position, place)) return next;
  if (is_corner) way.lane = Lane{place, forward};
  return place;
}

/// Whether the floor is bounded on both sides all along this line.
bool WayFinder::isCorridor(const Vector2& from, const Vector2& to, const Vector2& forward, double radius) const {
  constexpr std::array<double, 4> SHARES = {0.0, 0.33, 0.67, 1.0};
  return std::all_of(SHARES.begin(), SHARES.end(), [&](double share) {
    return ruler_->widthAt(from + share * (to - from), forward, radius, LANE_WIDTH).total() < LANE_WIDTH;
  });
}

/// The place to the right, on the line across the floor, where agents in this direction pass.
Vector2 WayFinder::laneBeside(const Vector2& place, const Vector2& forward, double radius) const {
  const FloorWidth room = ruler_->widthAt(place, forward, radius, LANE_WIDTH);
  if (room.total() > LANE_WIDTH || room.total() < 2.0 * radius + LANE_ROOM) return place;
  const double shift = room.right - std::max(LANE_MARGIN, LANE_SHARE * room.total());
  return shift > 0.0 ? Vector2(place + shift * Vector2(forward.y(), -forward.x())) : place;
}

}  // namespace crowd
