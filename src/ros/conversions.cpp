#include "social_crowd/ros/conversions.h"

#include <cmath>

#include "social_crowd/common/errors.h"

namespace crowd {
namespace {

social_crowd::AgentPerception toMessage(const AgentPerception& self) {
  social_crowd::AgentPerception message;
  message.agent = self.agent;
  message.pose.x = self.pose.position.x();
  message.pose.y = self.pose.position.y();
  message.pose.theta = self.pose.heading;
  message.velocity_x = self.velocity.x();
  message.velocity_y = self.velocity.y();
  message.speed = self.speed;
  message.radius = self.radius;
  message.goal_x = self.goal.x();
  message.goal_y = self.goal.y();
  message.goal_number = self.goal_number;
  message.arrived = self.arrived ? 1 : 0;
  message.acted = self.acted ? 1 : 0;
  message.first_body = self.first_body;
  message.body_count = self.body_count;
  message.first_wall = self.first_wall;
  message.wall_count = self.wall_count;
  return message;
}

AgentPerception fromMessage(const social_crowd::AgentPerception& message) {
  AgentPerception self;
  self.agent = message.agent;
  self.pose = {{message.pose.x, message.pose.y}, message.pose.theta};
  self.velocity = {message.velocity_x, message.velocity_y};
  self.speed = message.speed;
  self.radius = message.radius;
  self.goal = {message.goal_x, message.goal_y};
  self.goal_number = message.goal_number;
  self.arrived = message.arrived != 0;
  self.acted = message.acted != 0;
  self.first_body = message.first_body;
  self.body_count = message.body_count;
  self.first_wall = message.first_wall;
  self.wall_count = message.wall_count;
  return self;
}

social_crowd::PerceivedBody toMessage(const PerceivedBody& body) {
  social_crowd::PerceivedBody message;
  message.kind = static_cast<std::uint8_t>(body.kind);
  message.x = body.position.x();
  message.y = body.position.y();
  message.velocity_x = body.velocity.x();
  message.velocity_y = body.velocity.y();
  message.radius = body.radius;
  return message;
}

PerceivedBody fromMessage(const social_crowd::PerceivedBody& message) {
  PerceivedBody body;
  body.kind = message.kind == social_crowd::PerceivedBody::AGENT ? BodyKind::AGENT : BodyKind::OBSTACLE;
  body.position = {message.x, message.y};
  body.velocity = {message.velocity_x, message.velocity_y};
  body.radius = message.radius;
  return body;
}

social_crowd::PerceivedWall toMessage(const Segment& wall) {
  social_crowd::PerceivedWall message;
  message.from_x = wall.from.x();
  message.from_y = wall.from.y();
  message.to_x = wall.to.x();
  message.to_y = wall.to.y();
  return message;
}

Segment fromMessage(const social_crowd::PerceivedWall& message) {
  return {{message.from_x, message.from_y}, {message.to_x, message.to_y}};
}

social_crowd::AgentState toMessage(const Agent& agent) {
  social_crowd::AgentState message;
  message.agent = agent.id;
  message.pose.x = agent.pose.position.x();
  message.pose.y = agent.pose.position.y();
  message.pose.theta = agent.pose.heading;
  message.velocity = toVector3(agent.velocity);
  message.speed = agent.speed;
  message.radius = agent.radius;
  message.goal = toPoint(agent.goal());
  message.status = static_cast<std::uint8_t>(agent.status);
  message.in_contact = agent.in_contact ? 1 : 0;
  message.touched = agent.touched ? 1 : 0;
  message.blocked = agent.blocked ? 1 : 0;
  message.blocked_moves = agent.blocked_moves;
  return message;
}

std::vector<social_crowd::ObstacleState> obstacleStates(const World& world) {
  std::vector<social_crowd::ObstacleState> states;
  for (const Obstacle& obstacle : world.obstacles()) {
    social_crowd::ObstacleState state;
    state.obstacle = static_cast<std::uint32_t>(states.size());
    state.position = toPoint(obstacle.path.position(world.time()));
    state.velocity = toVector3(obstacle.path.velocity(world.time()));
    state.radius = obstacle.radius;
    states.push_back(state);
  }
  return states;
}

social_crowd::AgentResult toMessage(const AgentResult& result, std::size_t agent) {
  social_crowd::AgentResult message;
  message.agent = static_cast<AgentId>(agent);
  message.arrived = result.arrived ? 1 : 0;
  message.removed = result.removed ? 1 : 0;
  message.touched = result.touched ? 1 : 0;
  message.blocked_moves = result.blocked_moves;
  message.ticks = result.ticks;
  message.path_length = result.path_length;
  message.path_ratio = result.path_ratio;
  message.time_ratio = result.time_ratio;
  message.turn_per_metre = result.turn_per_metre;
  message.max_speed_ratio = result.max_speed_ratio;
  return message;
}

void checkPart(std::uint32_t first, std::uint32_t count, std::size_t size, const char* what) {
  if (std::uint64_t{first} + count <= size) return;
  throw InputError(std::string("perceptions: the ") + what + " of an agent lie beyond the list of " +
                   std::to_string(size));
}

void checkNumbers(const AgentPerception& self) {
  const bool finite = std::isfinite(self.goal.x()) && std::isfinite(self.goal.y()) && std::isfinite(self.speed) &&
                      std::isfinite(self.radius);
  if (!finite)
    throw InputError("perceptions: goal, speed or radius of agent " + std::to_string(self.agent) +
                     " is not a finite number");
  if (self.agent >= AGENT_LIMIT) throw InputError("perceptions: there is no agent " + std::to_string(self.agent));
}

}  // namespace

geometry_msgs::Point toPoint(const Vector2& v) {
  geometry_msgs::Point point;
  point.x = v.x();
  point.y = v.y();
  return point;
}

geometry_msgs::Vector3 toVector3(const Vector2& v) {
  geometry_msgs::Vector3 vector;
  vector.x = v.x();
  vector.y = v.y();
  return vector;
}

Vector2 fromPoint(const geometry_msgs::Point& point) { return {point.x, point.y}; }
Vector2 fromVector3(const geometry_msgs::Vector3& vector) { return {vector.x, vector.y}; }

void toMessage(const Perceptions& perceptions, social_crowd::Perceptions& message) {
  message.episode = perceptions.episode;
  message.tick = perceptions.tick;
  message.tick_duration = perceptions.tick_duration;
  message.last = perceptions.last ? 1 : 0;
  message.agents.clear();
  message.bodies.clear();
  message.walls.clear();
  for (std::size_t i = 0; i < perceptions.agents.size(); ++i) {
    message.agents.push_back(toMessage(perceptions.agents[i]));
    message.agents.back().first_body = static_cast<std::uint32_t>(message.bodies.size());
    for (const PerceivedBody& body : Perception(perceptions, i).bodies) message.bodies.push_back(toMessage(body));
  }
  for (const Segment& wall : perceptions.walls) message.walls.push_back(toMessage(wall));
}

void fromMessage(const social_crowd::Perceptions& message, Perceptions& perceptions) {
  perceptions.episode = message.episode;
  perceptions.tick = message.tick;
  perceptions.tick_duration = message.tick_duration;
  perceptions.last = message.last != 0;
  perceptions.agents.clear();
  perceptions.bodies.clear();
  perceptions.walls.clear();
  for (const auto& self : message.agents) {
    perceptions.agents.push_back(fromMessage(self));
    checkNumbers(perceptions.agents.back());
    checkPart(self.first_body, self.body_count, message.bodies.size(), "bodies");
    checkPart(self.first_wall, self.wall_count, message.walls.size(), "walls");
  }
  for (const auto& body : message.bodies) perceptions.bodies.push_back(fromMessage(body));
  for (const auto& wall : message.walls) perceptions.walls.push_back(fromMessage(wall));
}

void toMessage(const RelativeActions& actions, social_crowd::RelativeActions& message) {
  message.episode = actions.episode;
  message.tick = actions.tick;
  message.agents.clear();
  for (const AgentAction& given : actions.agents) {
    social_crowd::RelativeAction action;
    action.agent = given.agent;
    action.rotation = given.action.rotation;
    action.speed_share = given.action.speed_share;
    message.agents.push_back(action);
  }
}

void fromMessage(const social_crowd::RelativeActions& message, RelativeActions& actions) {
  actions.episode = message.episode;
  actions.tick = message.tick;
  actions.agents.clear();
  for (const auto& action : message.agents) {
    actions.agents.push_back({action.agent, {action.rotation, action.speed_share}});
  }
}

void toMessage(const World& world, social_crowd::AgentStates& message) {
  message.tick = world.tick();
  message.time = world.time();
  message.agents.clear();
  for (const Agent& agent : world.agents()) message.agents.push_back(toMessage(agent));
  message.obstacles = obstacleStates(world);
}

void toMessage(const EpisodeResult& result, social_crowd::EpisodeResult& message) {
  Figures figures;
  figures.add(result);
  message.tick = result.ticks;
  message.scenario = result.scenario;
  message.success_percent = figures.successPercent();
  message.contact_percent = figures.contactPercent();
  message.blocked_moves = result.blockedMoves();
  message.agents.clear();
  for (const AgentResult& agent : result.agents) message.agents.push_back(toMessage(agent, message.agents.size()));
}

void toMessage(const Scene& scene, const World& world, social_crowd::Scenario& message) {
  message.tick = world.tick();
  message.name = scene.name;
  message.tick_duration = scene.tick_duration;
  message.max_ticks = scene.max_ticks;
  message.goal_tolerance = scene.goal_tolerance;
  message.contact = static_cast<std::uint8_t>(scene.contact);
  message.agents.clear();
  for (const Agent& agent : world.agents()) message.agents.push_back(toMessage(agent));
  message.obstacles = obstacleStates(world);
  message.walls.clear();
  for (const Segment& segment : scene.walls) {
    social_crowd::Wall wall;
    wall.from = toPoint(segment.from);
    wall.to = toPoint(segment.to);
    message.walls.push_back(wall);
  }
}

}  // namespace crowd
