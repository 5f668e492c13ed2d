#include <algorithm>
#include <cmath>
#include <string>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/world/world.h"

namespace crowd {
namespace {

void requireFinite(const std::string& what, double value) {
  if (!std::isfinite(value)) throw InputError(what + ": expected a finite number, got " + toText(value));
}

void requireAbove(const std::string& what, double value) {
  requireFinite(what, value);
  if (value <= 0.0) throw InputError(what + ": expected a number above 0, got " + toText(value));
}

void requirePoint(const std::string& what, const Vector2& point) {
  requireFinite(what, point.x());
  requireFinite(what, point.y());
}

}  // namespace

void World::addAgent(const AgentStart& start) {
  Agent& agent = agents_.emplace_back();
  agent.id = static_cast<AgentId>(agents_.size() - 1);
  agent.pose = {start.position, wrapAngle(start.heading)};
  agent.ahead = unitVector(agent.pose.heading);
  agent.max_speed = start.max_speed;
  agent.radius = start.radius;
  agent.goals = start.goals;
  agent.present_goal = start.goals.front();
  ++active_count_;
}

Agent& World::findWalking(AgentId id) {
  if (!isActive(id)) throw InputError("there is no agent " + std::to_string(id) + " on its way");
  return agents_[id];
}

void World::requireFreePlace(const Vector2& centre, double radius, bool agents_only) {
  const double overlap = contact_ == Contact::SOLID ? TOUCH_TOLERANCE : CONTACT_OVERLAP;
  found_.clear();
  grid_.findNear(centre, radius - overlap, found_);
  for (const std::uint32_t body : found_) {
    if (body < agents_.size()) throw InputError("the place is taken by agent " + std::to_string(body));
    if (agents_only) continue;
    throw InputError("the place is taken by obstacle " + std::to_string(body - agents_.size()));
  }
  if (agents_only) return;
  const auto taken = [&](const Segment& wall) { return distanceTo(wall, centre) < radius - overlap; };
  if (std::any_of(walls_.begin(), walls_.end(), taken)) throw InputError("the place is taken by a wall");
}

AgentId World::spawnAgent(const AgentStart& start) {
  requireAbove("max_speed [m/s]", start.max_speed);
  requireAbove("radius [m]", start.radius);
  requireFinite("heading [rad]", start.heading);
  requirePoint("position [m]", start.position);
  if (start.goals.empty()) throw InputError("goals: expected at least one, got none");
  for (const Vector2& goal : start.goals) requirePoint("goal [m]", goal);
  requireFreePlace(start.position, start.radius, false);
  addAgent(start);
  refresh();
  return agents_.back().id;
}

void World::removeAgent(AgentId id) {
  findWalking(id).status = AgentStatus::REMOVED;
  --active_count_;
  refresh();
}

void World::setGoal(AgentId id, const Vector2& goal) {
  requirePoint("goal [m]", goal);
  Agent& agent = findWalking(id);
  agent.goals = {goal};
  agent.next_goal = 0;
  agent.present_goal = goal;
  ++agent.goal_number;
}

std::size_t World::spawnObstacle(const Vector2& position, const Vector2& velocity, double radius) {
  requireAbove("radius [m]", radius);
  requirePoint("position [m]", position);
  requirePoint("velocity [m/s]", velocity);
  requireFreePlace(position, radius, true);
  // Paths are functions of the time since the start of the episode: extrapolate the position back to that time.
  const bool rests = velocity == Vector2::Zero();
  obstacles_.push_back(
      {rests ? ObstaclePath::atRest(position) : ObstaclePath::straight(position - time() * velocity, velocity),
       radius});
  refresh();
  return obstacles_.size() - 1;
}

void World::removeObstacle(std::size_t number) {
  if (number >= obstacles_.size()) throw InputError("there is no obstacle " + std::to_string(number));
  obstacles_.erase(obstacles_.begin() + static_cast<std::ptrdiff_t>(number));
  refresh();
}

}  // namespace crowd
