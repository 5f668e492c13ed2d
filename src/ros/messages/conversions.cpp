#include "ros/messages/conversions.h"

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/utils.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <utility>

#include "simulation/evaluation/metrics.h"

namespace crowd {
namespace {

void toMessage(const Agent& agent, social_crowd::AgentState& message) {
  message.agent = agent.id;
  message.pose.x = agent.pose.position.x();
  message.pose.y = agent.pose.position.y();
  message.pose.theta = agent.pose.heading;
  message.velocity = toVector3(agent.velocity);
  message.max_speed = agent.max_speed;
  message.radius = agent.radius;
  message.figure = static_cast<std::uint8_t>(agent.figure);
  message.group = agent.group + 1;  // 0 for NO_GROUP
  message.goal = toPoint(agent.goal());
  message.status = static_cast<std::uint8_t>(agent.status);
  message.in_contact = agent.in_contact ? 1 : 0;
  message.touched = agent.touched ? 1 : 0;
  message.in_collision = agent.in_collision ? 1 : 0;
  message.collided = agent.collided ? 1 : 0;
  message.blocked = agent.blocked ? 1 : 0;
  message.blocked_moves = agent.blocked_moves;
}

void toMessages(const AgentMap<Agent>& agents, std::vector<social_crowd::AgentState>& messages) {
  messages.resize(agents.size());
  for (std::size_t i = 0; i < agents.size(); ++i) toMessage(agents.nth(i), messages[i]);
}

std::vector<social_crowd::ObstacleState> obstacleStates(const World& world) {
  std::vector<social_crowd::ObstacleState> states;
  for (std::size_t i = 0; i < world.obstacles().size(); ++i) {
    const Obstacle& obstacle = world.obstacles()[i];
    if (!world.isPresent(obstacle)) continue;
    social_crowd::ObstacleState state;
    state.obstacle = static_cast<std::uint32_t>(i);
    state.recorded = obstacle.person ? 1 : 0;
    state.person = obstacle.person.value_or(0);
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
  message.removed = result.removed ? 1 : 0;
  AgentResult::visitMeasures([](const char* /*name*/, const auto& value, auto& field) { field = value; }, result,
                             message);
  message.max_speed_ratio = result.max_speed_ratio;
  return message;
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

geometry_msgs::Quaternion toQuaternion(double heading) {
  tf2::Quaternion rotation;
  rotation.setRPY(0.0, 0.0, heading);
  return tf2::toMsg(rotation);
}

Vector2 fromPoint(const geometry_msgs::Point& point) { return {point.x, point.y}; }
Vector2 fromVector3(const geometry_msgs::Vector3& vector) { return {vector.x, vector.y}; }

void toMessage(const World& world, social_crowd::AgentStates& message) {
  message.tick = world.tick();
  message.time = world.time();
  toMessages(world.agents(), message.agents);
  message.obstacles = obstacleStates(world);
}

social_crowd::RobotResult toMessage(const RobotResult& result) {
  social_crowd::RobotResult message;
  message.robot = result.name;
  const auto copy = [](const char* /*name*/, const auto& value, auto& field) { field = value; };
  RobotResult::visitMeasures(copy, result, message);
  RobotInput::visitFields(copy, result.input, message);
  for (const RobotGoalResult& goal : result.goals) {
    RobotGoalResult::visitFields(copy, goal, message.goals.emplace_back());
  }
  return message;
}

void toMessage(const EpisodeResult& result, social_crowd::EpisodeResult& message) {
  Metrics metrics;
  metrics.add(result);
  message.tick = result.ticks;
  message.scenario = result.scenario;
  message.success_percent = metrics.successPercent();
  message.contact_percent = metrics.contactPercent();
  message.collision_percent = metrics.collisionPercent();
  message.blocked_moves = result.blockedMoves();
  message.out_of_reach = result.outOfReach();
  message.agents.clear();
  for (const AgentResult& agent : result.agents) message.agents.push_back(toMessage(agent, message.agents.size()));
  message.robots.clear();
  for (const RobotResult& robot : result.robots) message.robots.push_back(toMessage(robot));
}

namespace {

social_crowd::RobotDescription descriptionOf(const RobotStart& robot) {
  social_crowd::RobotDescription message;
  message.name = robot.name;
  message.name_space = robot.name_space;
  message.drive = DRIVES.nameOf(robot.drive);
  message.radius = robot.footprint.reach();
  for (const Vector2& corner : robot.footprint.corners) message.footprint.push_back(toPoint(corner));
  message.max_speed = robot.limits.max_speed;
  message.max_rotation = robot.limits.max_rotation;
  message.acceleration = robot.limits.max_acceleration;
  message.rotation_acceleration = robot.limits.max_rotation_acceleration;
  message.min_turning_radius = robot.limits.min_turning_radius;
  message.goal_tolerance = robot.goal_tolerance;
  return message;
}

}  // namespace

void toMessage(const Scene& scene, const World& world, social_crowd::Scenario& message) {
  message.tick = world.tick();
  message.name = scene.name;
  message.tick_duration = scene.tick_duration;
  message.max_ticks = scene.max_ticks;
  message.goal_tolerance = scene.goal_tolerance;
  message.collision_radius = scene.collision_radius;
  message.order = static_cast<std::uint8_t>(scene.order);
  message.contact = static_cast<std::uint8_t>(scene.contact);
  toMessages(world.agents(), message.agents);
  message.obstacles = obstacleStates(world);
  toMessages(scene.walls, message.walls);
  message.has_map = scene.map != nullptr ? 1 : 0;
  message.robots.clear();
  for (const RobotStart& robot : scene.robots) message.robots.push_back(descriptionOf(robot));
}

void toMessages(const std::vector<Segment>& walls, std::vector<social_crowd::Wall>& messages) {
  messages.resize(walls.size());
  for (std::size_t i = 0; i < walls.size(); ++i) {
    messages[i].from = toPoint(walls[i].from);
    messages[i].to = toPoint(walls[i].to);
  }
}

void toMessage(const OccupancyMap& map, nav_msgs::OccupancyGrid& message) {
  message.info.resolution = static_cast<float>(map.resolution);
  message.info.width = map.width;
  message.info.height = map.height;
  message.info.origin.position = toPoint(map.origin.position);
  message.info.origin.orientation = toQuaternion(map.origin.heading);
  const auto value_of = [](CellState state) -> std::int8_t {
    if (state == CellState::UNKNOWN) return -1;
    return state == CellState::OCCUPIED ? 100 : 0;
  };
  message.data.resize(map.cells.size());
  std::transform(map.cells.begin(), map.cells.end(), message.data.begin(), value_of);
}

OccupancyMap fromMessage(const nav_msgs::OccupancyGrid& message) {
  const geometry_msgs::Pose& origin = message.info.origin;
  OccupancyMap layout;
  layout.resolution = static_cast<double>(message.info.resolution);
  layout.origin = {fromPoint(origin.position), tf2::getYaw(origin.orientation)};
  layout.width = message.info.width;
  layout.height = message.info.height;
  return mapFromGrid(std::move(layout), message.data);
}

}  // namespace crowd
