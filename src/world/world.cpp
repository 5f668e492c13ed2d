#include "social_crowd/world/world.h"

#include <algorithm>
#include <string>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

constexpr double CELL_SIZE = 2.0;  // [m]; about the reach of a look around at walking distances

Agent makeAgent(AgentId id, const AgentStart& start) {
  Agent agent;
  agent.id = id;
  agent.pose = {start.position, wrapAngle(start.heading)};
  agent.speed = start.speed;
  agent.radius = start.radius;
  agent.goals = start.goals;
  return agent;
}

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

void checkAction(const AgentAction& given) {
  const RelativeAction& action = given.action;
  const bool fine = std::isfinite(action.rotation) && action.speed_share >= 0.0 && action.speed_share <= 1.0;
  if (fine) return;
  throw InputError("agent " + std::to_string(given.agent) +
                   ": expected a finite rotation and a share of the speed from 0 to 1, got rotation " +
                   toText(action.rotation) + " and share " + toText(action.speed_share));
}

}  // namespace

World::World(const Scene& scene)
    : tick_duration_(scene.tick_duration),
      goal_tolerance_(scene.goal_tolerance),
      obstacles_(scene.obstacles),
      walls_(scene.walls),
      active_count_(scene.agents.size()) {
  for (const AgentStart& start : scene.agents) {
    agents_.push_back(makeAgent(static_cast<AgentId>(agents_.size()), start));
  }
  refresh();
}

void World::refresh() {
  placeObstacles();
  rebuildGrid();
}

Agent* World::find(AgentId id) { return id < agents_.size() ? &agents_[id] : nullptr; }

bool World::isActive(AgentId id) const { return id < agents_.size() && agents_[id].isWalking(); }

void World::placeObstacles() {
  obstacle_positions_.clear();
  obstacle_velocities_.clear();
  for (const Obstacle& obstacle : obstacles_) {
    obstacle_positions_.push_back(obstacle.path.position(time()));
    obstacle_velocities_.push_back(obstacle.path.velocity(time()));
  }
}

void World::rebuildGrid() {
  grid_.clear();
  for (const Agent& agent : agents_) {
    if (agent.isWalking()) grid_.add(agent.pose.position, agent.radius, agent.id);
  }
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    grid_.add(obstacle_positions_[i], obstacles_[i].radius, static_cast<std::uint32_t>(agents_.size() + i));
  }
  grid_.build(CELL_SIZE);
}

void World::step(const std::vector<AgentAction>& actions) {
  for (const AgentAction& given : actions) checkAction(given);
  for (Agent& agent : agents_) {
    agent.acted = false;
    agent.velocity = Vector2::Zero();
  }
  for (const AgentAction& given : actions) {
    Agent* const agent = find(given.agent);
    if (agent != nullptr && agent->isWalking() && !agent->acted) moveAgent(*agent, given.action);
  }
  ++tick_;
  refresh();
  noteContacts();  // who arrives in this tick still stands on the floor at its end
  if (noteArrivals()) rebuildGrid();
}

void World::moveAgent(Agent& agent, const RelativeAction& action) const {
  agent.pose.heading = wrapAngle(agent.pose.heading + action.rotation);
  agent.velocity = action.speed_share * agent.speed * unitVector(agent.pose.heading);
  agent.pose.position += tick_duration_ * agent.velocity;
  agent.acted = true;
}

bool World::noteArrivals() {
  const std::size_t before = active_count_;
  for (Agent& agent : agents_) {
    if (!agent.isWalking() || (agent.goal() - agent.pose.position).norm() > goal_tolerance_) continue;
    if (++agent.next_goal < agent.goals.size()) {
      ++agent.goal_number;
      continue;
    }
    agent.status = AgentStatus::ARRIVED;
    agent.arrival_tick = tick_;
    --active_count_;
  }
  return active_count_ != before;
}

void World::noteContacts() {
  for (Agent& agent : agents_) {
    agent.in_contact = false;
    if (!agent.isWalking()) continue;
    found_.clear();
    grid_.findNear(agent.pose.position, agent.radius - CONTACT_OVERLAP, found_);
    const bool body = std::any_of(found_.begin(), found_.end(), [&](std::uint32_t other) { return other != agent.id; });
    const bool wall = std::any_of(walls_.begin(), walls_.end(), [&](const Segment& segment) {
      return distanceTo(segment, agent.pose.position) < agent.radius - CONTACT_OVERLAP;
    });
    agent.in_contact = body || wall;
    agent.touched = agent.touched || agent.in_contact;
  }
}

void World::perceive(const Vision& vision, Perceptions& perceptions) {
  perceptions.tick = tick_;
  perceptions.tick_duration = tick_duration_;
  perceptions.agents.clear();
  perceptions.bodies.clear();
  perceptions.walls.clear();
  for (const Agent& agent : agents_) {
    const bool just_arrived = agent.hasArrived() && agent.arrival_tick == tick_;
    if (!agent.isWalking() && !just_arrived) continue;
    const Rotation frame(agent.pose.heading);
    AgentPerception self;
    self.agent = agent.id;
    self.pose = agent.pose;
    self.velocity = frame.intoFrame(agent.velocity);
    self.speed = agent.speed;
    self.radius = agent.radius;
    self.goal = frame.intoFrame(agent.goal() - agent.pose.position);
    self.goal_number = agent.goal_number;
    self.arrived = agent.hasArrived();
    self.acted = agent.acted;
    self.first_body = static_cast<std::uint32_t>(perceptions.bodies.size());
    perceiveBodies(agent, frame, vision, perceptions);
    self.body_count = static_cast<std::uint32_t>(perceptions.bodies.size()) - self.first_body;
    self.first_wall = static_cast<std::uint32_t>(perceptions.walls.size());
    perceiveWalls(agent, frame, vision, perceptions);
    self.wall_count = static_cast<std::uint32_t>(perceptions.walls.size()) - self.first_wall;
    perceptions.agents.push_back(self);
  }
}

void World::perceiveBodies(const Agent& agent, const Rotation& frame, const Vision& vision, Perceptions& perceptions) {
  found_.clear();
  grid_.findNear(agent.pose.position, vision.radius, found_);
  near_.clear();
  const auto is_agent = [&](std::uint32_t body) { return body < agents_.size(); };
  for (const std::uint32_t body : found_) {
    if (body == agent.id) continue;
    const Vector2& centre = is_agent(body) ? agents_[body].pose.position : obstacle_positions_[body - agents_.size()];
    const double radius = is_agent(body) ? agents_[body].radius : obstacles_[body - agents_.size()].radius;
    near_.push_back({(centre - agent.pose.position).norm() - radius, body});
  }
  const auto nearer = [](const NearBody& a, const NearBody& b) {
    return a.rim_distance < b.rim_distance || (a.rim_distance == b.rim_distance && a.body < b.body);
  };
  std::sort(near_.begin(), near_.end(), nearer);
  if (vision.max_bodies > 0 && near_.size() > vision.max_bodies) near_.resize(vision.max_bodies);
  for (const NearBody& near : near_) {
    PerceivedBody seen;
    if (is_agent(near.body)) {
      const Agent& other = agents_[near.body];
      seen = {frame.intoFrame(other.pose.position - agent.pose.position), frame.intoFrame(other.velocity), other.radius,
              BodyKind::AGENT};
    } else {
      const std::size_t other = near.body - agents_.size();
      seen = {frame.intoFrame(obstacle_positions_[other] - agent.pose.position),
              frame.intoFrame(obstacle_velocities_[other]), obstacles_[other].radius, BodyKind::OBSTACLE};
    }
    perceptions.bodies.push_back(seen);
  }
}

void World::perceiveWalls(const Agent& agent, const Rotation& frame, const Vision& vision,
                          Perceptions& perceptions) const {
  for (const Segment& wall : walls_) {
    if (distanceTo(wall, agent.pose.position) > vision.radius) continue;
    perceptions.walls.push_back(
        {frame.intoFrame(wall.from - agent.pose.position), frame.intoFrame(wall.to - agent.pose.position)});
  }
}

Agent& World::findWalking(AgentId id) {
  if (!isActive(id)) throw InputError("there is no agent " + std::to_string(id) + " on its way");
  return agents_[id];
}

void World::requireFreePlace(const Vector2& centre, double radius, bool agents_only) {
  found_.clear();
  grid_.findNear(centre, radius - CONTACT_OVERLAP, found_);
  for (const std::uint32_t body : found_) {
    if (body < agents_.size()) throw InputError("the place is taken by agent " + std::to_string(body));
    if (agents_only) continue;
    throw InputError("the place is taken by obstacle " + std::to_string(body - agents_.size()));
  }
  if (agents_only) return;
  const auto taken = [&](const Segment& wall) { return distanceTo(wall, centre) < radius - CONTACT_OVERLAP; };
  if (std::any_of(walls_.begin(), walls_.end(), taken)) throw InputError("the place is taken by a wall");
}

AgentId World::spawnAgent(const AgentStart& start) {
  requireAbove("speed [m/s]", start.speed);
  requireAbove("radius [m]", start.radius);
  requireFinite("heading [rad]", start.heading);
  requirePoint("position [m]", start.position);
  if (start.goals.empty()) throw InputError("goals: expected at least one, got none");
  for (const Vector2& goal : start.goals) requirePoint("goal [m]", goal);
  requireFreePlace(start.position, start.radius, false);
  const auto id = static_cast<AgentId>(agents_.size());
  agents_.push_back(makeAgent(id, start));
  ++active_count_;
  refresh();
  return id;
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
  ++agent.goal_number;
}

std::size_t World::spawnObstacle(const Vector2& position, const Vector2& velocity, double radius) {
  requireAbove("radius [m]", radius);
  requirePoint("position [m]", position);
  requirePoint("velocity [m/s]", velocity);
  requireFreePlace(position, radius, true);
  // Paths are functions of the time since the episode's start: begin where it would have been then.
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
