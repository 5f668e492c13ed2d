#include "social_crowd/simulation/deadlock_resolver.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "social_crowd/simulation/remaining_path.h"

namespace crowd {
namespace {

constexpr double TRAIL_STEP = 0.5;        // between places of a trail [m]
constexpr std::size_t TRAIL_LENGTH = 20;  // places
constexpr double REACH = 0.6;             // between bodies that block each other [m]
constexpr double TOUCH = 0.1;             // bodies nearer to each other than this may wedge [m]
constexpr double BESIDE = 0.2;            // behind the line beside an agent [m]
constexpr double OPPOSITE = -0.3;         // cosine of the angle from which directions are opposite
constexpr double BACK = 1.0;              // an agent that walks back perceives a goal at least this far away [m]
constexpr double AXIS_TURN = 2.399963;    // golden angle: the axis takes all directions [rad]

Vector2 priorityDirection(double time) {
  const double angle = AXIS_TURN * std::floor(time / DeadlockResolver::TURN_TIME);
  return {std::cos(angle), std::sin(angle)};
}

/// Direction to the point of a path at LOOKAHEAD: agents in front of a door all walk in the same direction.
Vector2 directionOf(const RemainingPath& path, const Agent& agent) {
  constexpr double LOOKAHEAD = 3.0;  // [m]
  Vector2 from = agent.pose.position;
  double left = LOOKAHEAD;
  for (const Vector2& corner : path) {
    const double length = (corner - from).norm();
    if (length > left) {
      from += left / length * (corner - from);
      break;
    }
    left -= length;
    from = corner;
  }
  const Vector2 offset = from - agent.pose.position;
  const double length = offset.norm();
  return length > 0.0 ? Vector2(offset / length) : agent.ahead;
}

}  // namespace

void DeadlockResolver::update(World& world, const std::vector<RemainingPath>& paths) {
  const double time = world.time();
  walks_.resize(world.agents().size());
  retreating_.clear();
  walkers_.clear();
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    follow(agent, time);
    if (time < walks_[agent.id].retreat_until) {
      retreating_.push_back(agent.id);
    } else {
      walks_[agent.id].course = directionOf(paths[agent.id], agent);
      if (isStuck(walks_[agent.id], time)) {
        walks_[agent.id].remaining = lengthOf(paths[agent.id], agent.pose.position);
      }
    }
  }
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking() || agent.yielding || agent.held || agent.at_goal) continue;
    Walk& walk = walks_[agent.id];
    if (time < walk.retreat_until || !mustGiveWay(world, agent)) continue;
    walk.retreat_until = time + RETREAT_TIME;
    walk.course = -walk.course;  // the agents that it meets head-on do not give way, too
    retreating_.push_back(agent.id);
  }
  std::sort(retreating_.begin(), retreating_.end());
  for (const AgentId agent : retreating_) retreat(world, world.agents()[agent]);
}

void DeadlockResolver::follow(const Agent& agent, double time) {
  Walk& walk = walks_[agent.id];
  const Vector2& place = agent.pose.position;
  if (agent.yielding || agent.held || agent.at_goal || walk.trail.empty() ||
      (place - walk.reference).norm() > PROGRESS) {
    walk.reference = place;
    walk.progress_time = time;
  }
  if (time < walk.retreat_until) return;
  if (!walk.trail.empty() && (place - walk.trail.back()).norm() < TRAIL_STEP) return;
  walk.trail.push_back(place);
  if (walk.trail.size() > TRAIL_LENGTH) walk.trail.pop_front();
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

bool DeadlockResolver::mustGiveWay(const World& world, const Agent& agent) {
  const double time = world.time();
  if (!isStuck(walks_[agent.id], time)) {
    if (retreating_.empty() || agent.velocity.norm() > 0.3 * agent.max_speed) return false;
    return std::any_of(retreating_.begin(), retreating_.end(),
                       [&](AgentId other) { return givesWayTo(agent, world.agents()[other], time); });
  }
  if (walkers_.empty()) sortByX(world);
  const double reach = agent.radius + largest_radius_ + REACH;
  const double x = agent.pose.position.x();
  const auto first = std::lower_bound(walkers_.begin(), walkers_.end(), x - reach,
                                      [](const Walker& walker, double low) { return walker.x < low; });
  const auto last = std::upper_bound(first, walkers_.end(), x + reach,
                                     [](double high, const Walker& walker) { return high < walker.x; });
  return std::any_of(first, last,
                     [&](const Walker& other) { return givesWayTo(agent, world.agents()[other.agent], time); });
}

/// Whether another agent blocks an agent that is stuck or in the way of one that walks back, and has priority.
bool DeadlockResolver::givesWayTo(const Agent& agent, const Agent& other, double time) const {
  if (other.id == agent.id) return false;
  const Walk& own = walks_[agent.id];
  const Walk& its = walks_[other.id];
  const Vector2 offset = other.pose.position - agent.pose.position;
  const double gap = offset.norm() - agent.radius - other.radius;
  // In a door two agents may be wedged side by side.
  const double ahead = offset.dot(own.course);
  if (gap > REACH || ahead <= (gap < TOUCH ? -BESIDE : 0.0)) return false;
  const bool retreats = time < its.retreat_until;
  if (its.course.dot(own.course) < OPPOSITE) {
    return retreats || priorityDirection(time).dot(its.course - own.course) > 0.0;
  }
  const bool forms_arch = gap < TOUCH && ahead > 0.0 && isStuck(own, time) && isStuck(its, time);
  return forms_arch && !retreats && its.remaining < own.remaining;
}

void DeadlockResolver::retreat(World& world, const Agent& agent) {
  std::deque<Vector2>& trail = walks_[agent.id].trail;
  while (trail.size() > 1 && (trail.back() - agent.pose.position).norm() < BACK) trail.pop_back();
  world.setWaypoint(agent.id, trail.back());
  const Vector2 back = trail.back() - agent.pose.position;
  if (back.norm() > 0.0) walks_[agent.id].course = back.normalized();
}

}  // namespace crowd
