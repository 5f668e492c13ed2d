#include "navigation/deadlock_resolver.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/portable_math.h"
#include "navigation/crowding.h"
#include "navigation/remaining_path.h"
#include "navigation/sliding.h"

namespace crowd {
namespace {

constexpr double REACH = 0.6;           // between bodies that block each other [m]
constexpr double WAITER_REACH = 0.2;    // between an agent that waits and one that it blocks [m]
constexpr double TOUCH = 0.1;           // bodies nearer to each other than this may wedge [m]
constexpr double BESIDE = 0.2;          // behind the line beside an agent [m]
constexpr double BACK = 1.0;            // distance of the goal that an agent perceives while it walks back [m]
constexpr double CONTACT = 0.02;        // an agent slides along what is nearer than this [m]
constexpr double AHEAD = 3.0;           // distance on its path of the point that gives an agent's direction [m]
constexpr double WALKED_BACK = 0.1;     // an agent that moved less could not walk back [m]
constexpr double AXIS_TURN = 2.399963;  // golden angle: the axis takes all directions [rad]

Vector2 priorityDirection(double time) {
  const double angle = AXIS_TURN * std::floor(time / DeadlockResolver::TURN_TIME);
  return {portable::cos(angle), portable::sin(angle)};
}

/// Direction to the point AHEAD on its path: agents in front of a door all walk in the same direction.
Vector2 directionTo(const Vector2& ahead, const Agent& agent) {
  const Vector2 offset = ahead - agent.pose.position;
  const double length = offset.norm();
  return length > 0.0 ? Vector2(offset / length) : agent.ahead;
}

}  // namespace

void DeadlockResolver::update(World& world, const AgentMap<RemainingPath>& paths, const CongestionMap& congestion) {
  const double time = world.time();
  walks_.follow(world.agents());
  retreating_.clear();
  walkers_.clear();
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (agent.isWalking()) follow(agent, paths.nth(i), time, walks_.nth(i));
  }
  for (std::size_t i = 0; i < world.agents().size(); ++i) {
    const Agent& agent = world.agents().nth(i);
    if (!agent.isWalking() || agent.isHeld() || agent.at_goal) continue;
    if (walksBack(walks_.nth(i))) continue;
    if (mustGiveWay(world, agent, congestion)) {
      startRetreat(agent, time);
    } else if (isStuck(walks_.nth(i), time)) {
      slideAlongWalls(world, agent);
    }
  }
  std::sort(retreating_.begin(), retreating_.end());
  for (const AgentId agent : retreating_) retreat(world, world.agents()[agent]);
}

void DeadlockResolver::follow(const Agent& agent, const RemainingPath& path, double time, Walk& walk) {
  const Vector2& place = agent.pose.position;
  noteProgress(agent, time, walk);
  if (time < walk.retreat_until) {
    retreating_.push_back(agent.id);
    return;
  }
  if (walksBack(walk)) walk.cannot_walk_back = (place - walk.retreat_from).norm() < WALKED_BACK;
  walk.retreat_until = 0.0;
  walk.ahead = pointAlong({path.data(), path.size()}, place, AHEAD);
  walk.course = directionTo(walk.ahead, agent);
  if (isStuck(walk, time)) walk.remaining = lengthOf({path.data(), path.size()}, place);
}

void DeadlockResolver::noteProgress(const Agent& agent, double time, Walk& walk) {
  const Vector2& place = agent.pose.position;
  const bool waits = agent.yielding || agent.isHeld() || agent.at_goal;
  const auto has_left = [&](const Stay& stay, double distance) {
    return waits || !stay.place || (place - *stay.place).norm() > distance;
  };
  if (has_left(walk.stay, PROGRESS)) {
    walk.stay = {place, time};
    walk.cannot_walk_back = false;
  }
  if (has_left(walk.pacing, PACING)) walk.pacing = {place, time};
}

void DeadlockResolver::startRetreat(const Agent& agent, double time) {
  Walk& walk = walks_[agent.id];
  walk.retreat_from = agent.pose.position;
  walk.retreat_until = time + RETREAT_TIME;
  walk.stay.begin = walk.retreat_until + WALK_TIME - STUCK_TIME;
  walk.pacing.begin = walk.retreat_until;
  walk.course = -walk.course;  // the agents that it meets head-on do not give way, too
  retreating_.push_back(agent.id);
}

void DeadlockResolver::sortByX(const World& world) {
  largest_radius_ = 0.0;
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    walkers_.push_back({agent.pose.position.x(), agent.id});
    largest_radius_ = std::max(largest_radius_, agent.radius);
  }
  std::sort(walkers_.begin(), walkers_.end(),
            [](const Walker& a, const Walker& b) { return std::tie(a.x, a.agent) < std::tie(b.x, b.agent); });
}

Span<DeadlockResolver::Walker> DeadlockResolver::walkersNear(const World& world, const Agent& agent, double distance) {
  if (walkers_.empty()) sortByX(world);
  const double reach = agent.radius + largest_radius_ + distance;
  const double x = agent.pose.position.x();
  const auto first = std::lower_bound(walkers_.begin(), walkers_.end(), x - reach,
                                      [](const Walker& walker, double low) { return walker.x < low; });
  const auto last = std::upper_bound(first, walkers_.end(), x + reach,
                                     [](double high, const Walker& walker) { return high < walker.x; });
  return {walkers_.data() + (first - walkers_.begin()), static_cast<std::size_t>(last - first)};
}

bool DeadlockResolver::mustGiveWay(const World& world, const Agent& agent, const CongestionMap& congestion) {
  const Walk& walk = walks_[agent.id];
  const auto share = [&] { return congestion.shareAt(agent.pose.position, walk.course); };
  const auto has_priority = [&](AgentId other) { return givesWayTo(world, agent, world.agents()[other]); };
  if (isStuck(walk, world.time())) {
    if (isBlockedByRobot(world, agent)) return true;
    if (share() < STANDS) {
      const Span<Walker> near = walkersNear(world, agent, REACH);
      return std::any_of(near.begin(), near.end(), [&](const Walker& other) { return has_priority(other.agent); });
    }
  }
  if (agent.yielding && blocksOthers(world, agent)) return true;
  if (retreating_.empty() || share() > GETS_ON) return false;
  return std::any_of(retreating_.begin(), retreating_.end(), has_priority);
}

/// Whether an agent that waits is in the way of one that is stuck.
bool DeadlockResolver::blocksOthers(const World& world, const Agent& agent) {
  const Span<Walker> near = walkersNear(world, agent, WAITER_REACH);
  return std::any_of(near.begin(), near.end(), [&](const Walker& walker) {
    const Agent& other = world.agents()[walker.agent];
    const Walk& its = walks_[other.id];
    const bool is_stuck = !other.yielding && !other.isHeld() && !walksBack(its) && isStuck(its, world.time());
    if (other.id == agent.id || !is_stuck) return false;
    const Vector2 offset = agent.pose.position - other.pose.position;
    const double gap = offset.norm() - agent.radius - other.radius;
    const Vector2 way = (other.perceivedGoal() - other.pose.position).normalized();
    return gap < WAITER_REACH && offset.dot(way) > (gap < TOUCH ? -BESIDE : 0.0) &&
           world.walls().index().isClear(agent.pose.position, other.pose.position, 0.0);
  });
}

/// Whether a robot that agents give way to is ahead of an agent, or touches it.
bool DeadlockResolver::isBlockedByRobot(const World& world, const Agent& agent) const {
  const auto blocks = [&](const Robot& robot) {
    if (!robot.start.perceived || !doesCrowdYield(robot.start.yields)) return false;
    const Vector2 offset = robot.pose.position - agent.pose.position;
    const double gap = offset.norm() - agent.radius - robot.perceived_radius;
    return gap < REACH && offset.dot(walks_[agent.id].course) > (gap < TOUCH ? -BESIDE : 0.0);
  };
  return std::any_of(world.robots().begin(), world.robots().end(), blocks);
}

/// Of two agents in opposite directions, above 0 if the first one has priority: who leaves a crowd goes before who
/// enters it. The axis counts like up to two people, so that not the same agents give way for ever.
double DeadlockResolver::priorityOver(const World& world, const Walk& own, const Walk& its) {
  const auto people_ahead = [&](const Walk& walk) {
    return static_cast<double>(countPeopleNear(world, walk.ahead, CROWD_RADIUS, near_people_));
  };
  const double axis = priorityDirection(world.time()).dot(own.course - its.course);
  return axis + people_ahead(its) - people_ahead(own);
}

/// Whether another agent blocks an agent that is stuck or in the way of one that walks back, and has priority.
bool DeadlockResolver::givesWayTo(const World& world, const Agent& agent, const Agent& other) {
  if (other.id == agent.id) return false;
  const double time = world.time();
  const Walk& own = walks_[agent.id];
  const Walk& its = walks_[other.id];
  const Vector2 offset = other.pose.position - agent.pose.position;
  const double gap = offset.norm() - agent.radius - other.radius;
  if (gap > REACH) return false;
  const bool is_opposite = its.course.dot(own.course) < OPPOSITE;
  const bool forms_arch = !is_opposite && gap < TOUCH && isStuck(own, time) && isStuck(its, time);
  // In a door two agents may be wedged side by side.
  const bool is_ahead = offset.dot(own.course) > (gap < TOUCH ? -BESIDE : 0.0);
  if (!is_ahead && !forms_arch) return false;
  if (!world.walls().index().isClear(agent.pose.position, other.pose.position, 0.0)) return false;
  if (own.cannot_walk_back != its.cannot_walk_back) return its.cannot_walk_back && (is_opposite || forms_arch);
  if (is_opposite) {
    if (walksBack(its)) return true;
    return !other.yielding && priorityOver(world, own, its) < 0.0;
  }
  return forms_arch && !walksBack(its) && its.remaining < own.remaining;
}

/// Appends unit vectors from an agent to the walls that it touches.
void DeadlockResolver::addWallContacts(const World& world, const Agent& agent, std::vector<Vector2>& contacts) {
  near_walls_.clear();
  world.walls().index().findNear(agent.pose.position, agent.radius + CONTACT, near_walls_);
  for (const std::uint32_t wall : near_walls_) {
    const Vector2 offset = nearestPoint(world.walls().index().walls()[wall], agent.pose.position) - agent.pose.position;
    if (offset.norm() > 0.0) contacts.emplace_back(offset.normalized());
  }
}

/// Appends unit vectors from an agent to the agents that it touches.
void DeadlockResolver::addAgentContacts(const World& world, const Agent& agent, std::vector<Vector2>& contacts) {
  for (const Walker& walker : walkersNear(world, agent, CONTACT)) {
    const Agent& other = world.agents()[walker.agent];
    const Vector2 offset = other.pose.position - agent.pose.position;
    const double length = offset.norm();
    const bool touches = length > 0.0 && length < agent.radius + other.radius + CONTACT;
    if (other.id != agent.id && touches) contacts.emplace_back(offset / length);
  }
}

/// An agent may be wedged between a wall and another agent in a door.
void DeadlockResolver::slideAlongWalls(World& world, const Agent& agent) {
  std::vector<Vector2> contacts;
  addAgentContacts(world, agent, contacts);
  const std::size_t agents = contacts.size();
  addWallContacts(world, agent, contacts);
  if (contacts.size() == agents) return;
  const Vector2 way = agent.perceivedGoal() - agent.pose.position;
  const std::optional<Vector2> slid = slideAlong(way.normalized(), contacts);
  if (slid) world.walkingAgent(agent.id).setWaypoint(agent.pose.position + BACK * *slid);
}

void DeadlockResolver::retreat(World& world, const Agent& agent) {
  const Vector2& course = walks_[agent.id].course;
  std::vector<Vector2> contacts;
  addAgentContacts(world, agent, contacts);
  addWallContacts(world, agent, contacts);
  Agent& retreating = world.walkingAgent(agent.id);
  retreating.yielding = false;
  retreating.setWaypoint(agent.pose.position + BACK * slideAlong(course, contacts).value_or(course));
}

}  // namespace crowd
