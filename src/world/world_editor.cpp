#include "world/world_editor.h"

#include <algorithm>
#include <string>
#include <utility>

#include "common/text/quotes.h"
#include "geometry/finite_checks.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// The path of an obstacle that is at a place at time `now` [s]. Paths are functions of the time since the start of the
/// episode: the position is extrapolated back to that time.
ObstaclePath pathFromNow(const Vector2& position, const Vector2& velocity, double now) {
  const bool rests = velocity == Vector2::Zero();
  return rests ? ObstaclePath::atRest(position) : ObstaclePath::straight(position - now * velocity, velocity);
}

}  // namespace

void WorldEditor::requireFreePlace(const Vector2& centre, double radius, bool agents_only,
                                   std::optional<AgentId> except, std::optional<RobotId> except_robot) const {
  const std::string blocker = world_.blockerAt(centre, radius, agents_only, except, except_robot);
  if (!blocker.empty()) throw InputError("the place is taken by " + blocker);
}

AgentId WorldEditor::spawnAgent(const AgentStart& start) {
  requireWithin(limits::SPEED, "max_speed [m/s]", start.max_speed);
  requireWithin(limits::RADIUS, "radius [m]", start.radius);
  requireFinite("heading [rad]", start.heading);
  requirePlace("position [m]", start.position);
  if (start.goals.empty()) throw InputError("goals: expected at least one, got none");
  for (const Vector2& goal : start.goals) requirePlace("goal [m]", goal);
  requireFreePlace(start.position, start.radius, false);
  const Agent agent(static_cast<AgentId>(world_.entered_count_), start);
  WorldChange change;
  change.agent = &agent;
  change.start = &start;
  review(change);
  world_.agents_.add(agent.id) = agent;
  ++world_.entered_count_;
  world_.has_groups_ = world_.has_groups_ || start.group != NO_GROUP;
  ++world_.active_count_;
  world_.rebuildGrid();
  note(change);
  return agent.id;
}

std::vector<Agent> WorldEditor::replaceAgents(std::vector<Agent> agents) {
  std::vector<Agent> former = world_.agents_.replace({});
  world_.active_count_ = 0;
  for (Agent& agent : agents) {
    world_.active_count_ += agent.isWalking() ? 1 : 0;
    world_.agents_.add(agent.id) = std::move(agent);
  }
  world_.lasting_count_ = agents.size();
  world_.rebuildGrid();
  note({});
  return former;
}

void WorldEditor::end(AgentId id, AgentStatus status) {
  Agent& agent = world_.walkingAgent(id);
  agent.end(status, world_.tick());
  --world_.active_count_;
  world_.rebuildGrid();
  note({});
}

void WorldEditor::removeAgent(AgentId id) { end(id, AgentStatus::REMOVED); }

void WorldEditor::leave(AgentId id) { end(id, AgentStatus::ARRIVED); }

void WorldEditor::arrive(AgentId id) { end(id, world_.walkingAgent(id).statusAtEnd()); }

void WorldEditor::setGoal(AgentId id, const Vector2& goal) {
  requirePlace("goal [m]", goal);
  Agent after = world_.walkingAgent(id);
  after.setGoal(goal);
  replaceAgent(after, true);
}

void WorldEditor::teleport(AgentId id, const Pose& pose) {
  requirePose(pose);
  Agent after = world_.walkingAgent(id);
  requireFreePlace(pose.position, after.radius, false, id);
  after.teleport(pose);
  replaceAgent(after, false);
}

void WorldEditor::replaceAgent(const Agent& agent, bool new_goal) {
  WorldChange change;
  change.agent = &agent;
  change.new_goal = new_goal;
  review(change);
  world_.agents_[agent.id] = agent;
  if (!new_goal) world_.rebuildGrid();
  note(change);
}

void WorldEditor::teleportRobot(RobotId id, const Pose& pose) {
  const double radius = world_.robots_.require(id).start.footprint.reach();
  requirePose(pose);
  requireFreePlace(pose.position, radius, false, std::nullopt, id);
  world_.robots_.teleport(id, pose);
  note({});
}

void WorldEditor::replaceObstacles(std::vector<Obstacle> obstacles) {
  WorldChange change;
  change.obstacles = &obstacles;
  review(change);
  world_.obstacles_ = Obstacles(std::move(obstacles), world_.time());
  world_.rebuildGrid();
  noteLayout({});
}

void WorldEditor::noteLayout(const WorldChange& change) {
  ++world_.layout_changes_;
  note(change);
}

const Obstacle& WorldEditor::requireObstacle(std::size_t number) const {
  if (number >= world_.obstacles().size()) throw InputError("there is no obstacle " + std::to_string(number));
  const Obstacle& obstacle = world_.obstacles()[number];
  if (!obstacle.person) return obstacle;
  throw InputError("obstacle " + std::to_string(number) + " is " + nameOf(obstacle, number) +
                   ", who cannot be moved or removed");
}

std::size_t WorldEditor::spawnObstacle(const Vector2& position, const Vector2& velocity, double radius) {
  requireWithin(limits::RADIUS, "radius [m]", radius);
  requirePlace("position [m]", position);
  requireWithin(limits::VELOCITY, "velocity [m/s]", velocity);
  requireFreePlace(position, radius, true);
  std::vector<Obstacle> obstacles = world_.obstacles();
  obstacles.push_back({pathFromNow(position, velocity, world_.time()), radius});
  replaceObstacles(std::move(obstacles));
  return world_.obstacles().size() - 1;
}

void WorldEditor::moveObstacle(std::size_t number, const Vector2& position) {
  const Obstacle& obstacle = requireObstacle(number);
  requirePlace("position [m]", position);
  requireFreePlace(position, obstacle.radius, true);
  const bool keeps = obstacle.path.kind() == ObstaclePath::Kind::STRAIGHT;
  const Vector2 velocity = keeps ? obstacle.path.velocity(world_.time()) : Vector2(Vector2::Zero());
  std::vector<Obstacle> obstacles = world_.obstacles();
  obstacles[number].path = pathFromNow(position, velocity, world_.time());
  replaceObstacles(std::move(obstacles));
}

void WorldEditor::removeObstacle(std::size_t number) {
  requireObstacle(number);
  std::vector<Obstacle> obstacles = world_.obstacles();
  obstacles.erase(obstacles.begin() + static_cast<std::ptrdiff_t>(number));
  world_.obstacles_ = Obstacles(std::move(obstacles), world_.time());
  world_.rebuildGrid();
  noteLayout({});
}

std::size_t WorldEditor::addWall(const Segment& wall) {
  requirePlace("wall [m]", wall.from);
  requirePlace("wall [m]", wall.to);
  if (wall.from == wall.to) throw InputError("expected a wall with a length, got twice the same end");
  for (const Agent& agent : world_.agents_) {
    if (agent.isPresent() && distanceTo(wall, agent.pose.position) < agent.radius - CONTACT_OVERLAP) {
      throw InputError("the place is taken by agent " + std::to_string(agent.id));
    }
  }
  for (const Robot& robot : world_.robots_) {
    if (isCutBy(robot.start.footprint, robot.pose, wall, CONTACT_OVERLAP)) {
      throw InputError("the place is taken by robot " + inQuotes(robot.start.name));
    }
  }
  std::vector<Segment> walls = world_.walls_.list();
  walls.push_back(wall);
  WorldChange change;
  change.walls = &walls;
  review(change);
  const std::size_t id = world_.walls_.add(wall);
  noteLayout(change);
  return id;
}

void WorldEditor::removeWall(std::size_t id) {
  world_.walls_.remove(id);
  WorldChange change;
  change.fewer_walls = true;
  noteLayout(change);
}

void WorldEditor::replaceWalls(std::vector<Segment> walls) {
  WorldChange change;
  change.walls = &walls;
  change.fewer_walls = true;
  review(change);
  world_.walls_.replaceAll(std::move(walls));
  noteLayout(change);
}

}  // namespace crowd
