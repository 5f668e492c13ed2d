#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "geometry/finite_checks.h"
#include "social_crowd/common/errors.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/common/quotes.h"
#include "social_crowd/geometry/impact.h"
#include "social_crowd/world/world.h"

namespace crowd {
namespace {

/// The path of an obstacle that is at a place at time `now` [s]. Paths are functions of the time since the start of the
/// episode: the position is extrapolated back to that time.
ObstaclePath pathFromNow(const Vector2& position, const Vector2& velocity, double now) {
  const bool rests = velocity == Vector2::Zero();
  return rests ? ObstaclePath::atRest(position) : ObstaclePath::straight(position - now * velocity, velocity);
}

}  // namespace

void World::addAgent(const AgentStart& start) {
  const auto id = static_cast<AgentId>(entered_count_++);
  Agent& agent = agents_.add(id);
  agent.id = id;
  agent.pose = {start.position, wrapAngle(start.heading)};
  agent.ahead = unitVector(agent.pose.heading);
  agent.max_speed = start.max_speed;
  agent.radius = start.radius;
  agent.leaves = start.leaves;
  agent.goals = start.goals;
  agent.present_goal = start.goals.front();
  ++active_count_;
}

Agent& World::findWalking(AgentId id) {
  if (!isActive(id)) throw InputError("there is no agent " + std::to_string(id) + " on its way");
  return agents_[id];
}

std::string World::findBlocker(const Vector2& centre, double radius, bool agents_only, std::optional<AgentId> except,
                               std::optional<RobotId> except_robot) const {
  const double overlap = contact_ == Contact::SOLID ? TOUCH_TOLERANCE : CONTACT_OVERLAP;
  std::vector<std::uint32_t> found;
  grid_.findNear(centre, radius - overlap, found);
  for (const std::uint32_t body : found) {
    if (body < agents_.size() && agents_.idAt(body) == except) continue;
    if (body < agents_.size()) return "agent " + std::to_string(agents_.idAt(body));
    if (!agents_only) return "obstacle " + std::to_string(body - agents_.size());
  }
  std::string robot = findRobotBlocker(centre, radius - overlap, except_robot);
  if (!robot.empty() || agents_only) return robot;
  return walls_.isAnyWithin(centre, radius - overlap) ? "a wall" : "";
}

void World::requireFreePlace(const Vector2& centre, double radius, bool agents_only,
                             std::optional<AgentId> except) const {
  const std::string blocker = findBlocker(centre, radius, agents_only, except);
  if (!blocker.empty()) throw InputError("the place is taken by " + blocker);
}

bool World::isFree(const Vector2& centre, double radius) const { return findBlocker(centre, radius, false).empty(); }

AgentId World::spawnAgent(const AgentStart& start) {
  requireWithin(limits::SPEED, "max_speed [m/s]", start.max_speed);
  requireWithin(limits::RADIUS, "radius [m]", start.radius);
  requireFinite("heading [rad]", start.heading);
  requirePlace("position [m]", start.position);
  if (start.goals.empty()) throw InputError("goals: expected at least one, got none");
  for (const Vector2& goal : start.goals) requireFinite("goal [m]", goal);
  requireFreePlace(start.position, start.radius, false);
  addAgent(start);
  refresh();
  return agents_.back().id;
}

std::vector<Agent> World::replaceAgents(std::vector<Agent> agents) {
  agents = agents_.replace(std::move(agents));
  lasting_count_ = entered_count_ = agents_.size();
  active_count_ = 0;
  just_arrived_count_ = 0;
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    agents_.nth(i).id = static_cast<AgentId>(i);
    active_count_ += agents_.nth(i).isWalking() ? 1 : 0;
  }
  refresh();
  return agents;
}

void World::removeAgent(AgentId id) {
  Agent& agent = findWalking(id);
  agent.status = AgentStatus::REMOVED;
  agent.arrival_tick = tick_;
  --active_count_;
  refresh();
}

void World::leave(AgentId id) {
  Agent& agent = findWalking(id);
  agent.status = AgentStatus::ARRIVED;
  agent.arrival_tick = tick_;
  ++just_arrived_count_;
  --active_count_;
  refresh();
}

void World::setGoal(AgentId id, const Vector2& goal) {
  requireFinite("goal [m]", goal);
  Agent& agent = findWalking(id);
  agent.goals = {goal};
  agent.next_goal = 0;
  agent.present_goal = goal;
  agent.has_waypoint = false;
  agent.at_goal = false;
  ++agent.goal_number;
}

void World::setWaypoint(AgentId id, const Vector2& waypoint) {
  requireFinite("waypoint [m]", waypoint);
  Agent& agent = findWalking(id);
  if (agent.has_waypoint && agent.waypoint == waypoint) return;
  agent.waypoint = waypoint;
  agent.has_waypoint = true;
  ++agent.goal_number;
}

void World::clearWaypoint(AgentId id) {
  Agent& agent = findWalking(id);
  if (!agent.has_waypoint) return;
  agent.has_waypoint = false;
  ++agent.goal_number;
}

void World::hold(AgentId id, bool held) { findWalking(id).held = held; }

void World::setLeaves(AgentId id, bool leaves) { findWalking(id).leaves = leaves; }

void World::setYielding(AgentId id, bool yielding) { findWalking(id).yielding = yielding; }

void World::teleport(AgentId id, const Pose& pose) {
  requirePose(pose);
  Agent& agent = findWalking(id);
  requireFreePlace(pose.position, agent.radius, false, id);
  agent.pose = {pose.position, wrapAngle(pose.heading)};
  agent.ahead = unitVector(agent.pose.heading);
  agent.velocity = Vector2::Zero();
  agent.has_waypoint = false;
  agent.at_goal = false;
  ++agent.goal_number;
  refresh();
}

std::size_t World::spawnObstacle(const Vector2& position, const Vector2& velocity, double radius) {
  requireWithin(limits::RADIUS, "radius [m]", radius);
  requirePlace("position [m]", position);
  requireWithin(limits::VELOCITY, "velocity [m/s]", velocity);
  requireFreePlace(position, radius, true);
  obstacles_.push_back({pathFromNow(position, velocity, time()), radius});
  ++layout_changes_;
  refresh();
  return obstacles_.size() - 1;
}

void World::moveObstacle(std::size_t number, const Vector2& position) {
  requireObstacle(number);
  requirePlace("position [m]", position);
  Obstacle& obstacle = obstacles_[number];
  requireFreePlace(position, obstacle.radius, true);
  const bool keeps = obstacle.path.kind() == ObstaclePath::Kind::STRAIGHT;
  obstacle.path = pathFromNow(position, keeps ? obstacle.path.velocity(time()) : Vector2(Vector2::Zero()), time());
  ++layout_changes_;
  refresh();
}

void World::requireObstacle(std::size_t number) const {
  if (number >= obstacles_.size()) throw InputError("there is no obstacle " + std::to_string(number));
}

void World::removeObstacle(std::size_t number) {
  requireObstacle(number);
  obstacles_.erase(obstacles_.begin() + static_cast<std::ptrdiff_t>(number));
  ++layout_changes_;
  refresh();
}

std::size_t World::addWall(const Segment& wall) {
  requirePlace("wall [m]", wall.from);
  requirePlace("wall [m]", wall.to);
  if (wall.from == wall.to) throw InputError("expected a wall with a length, got twice the same end");
  for (const Agent& agent : agents_) {
    if (agent.isWalking() && distanceTo(wall, agent.pose.position) < agent.radius - CONTACT_OVERLAP) {
      throw InputError("the place is taken by agent " + std::to_string(agent.id));
    }
  }
  for (const Robot& robot : robots_) {
    if (isCutBy(robot.start.footprint, robot.pose, wall, CONTACT_OVERLAP)) {
      throw InputError("the place is taken by robot " + inQuotes(robot.start.name));
    }
  }
  std::vector<Segment> walls = this->walls();
  walls.push_back(wall);
  setWalls(std::move(walls));
  wall_ids_.push_back(next_wall_id_++);
  return wall_ids_.back();
}

void World::setWalls(std::vector<Segment> walls) {
  const bool are_many = walls.size() > MANY_WALLS;
  wall_reach_ = are_many ? NEAR_WALLS : std::numeric_limits<double>::infinity();
  walls_ = WallIndex(std::move(walls), are_many ? NEAR_WALLS : 0.0);
  ++layout_changes_;
}

void World::removeWall(std::size_t id) {
  const auto found = std::lower_bound(wall_ids_.begin(), wall_ids_.end(), id);
  if (found == wall_ids_.end() || *found != id) throw InputError("there is no wall " + std::to_string(id));
  std::vector<Segment> walls = this->walls();
  walls.erase(walls.begin() + (found - wall_ids_.begin()));
  setWalls(std::move(walls));
  wall_ids_.erase(found);
}

void World::replaceWalls(std::vector<Segment> walls) {
  setWalls(std::move(walls));
  wall_ids_.resize(this->walls().size());
  for (std::size_t& id : wall_ids_) id = next_wall_id_++;
}

}  // namespace crowd
