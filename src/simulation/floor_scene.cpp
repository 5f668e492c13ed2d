#include "simulation/floor_scene.h"

#include <algorithm>
#include <map>
#include <optional>

#include "scenario/population_spec.h"

namespace crowd {
namespace {

AgentStart startOf(const Agent& agent, const Scene& scene) {
  AgentStart start;
  start.position = agent.pose.position;
  start.heading = agent.pose.heading;
  start.goals.assign(agent.goals.begin() + static_cast<std::ptrdiff_t>(agent.next_goal), agent.goals.end());
  start.max_speed = agent.own_speed;
  start.hurry = agent.paces[static_cast<std::size_t>(Pace::HURRY)];
  start.radius = agent.radius;
  start.kind = agent.kind;
  start.figure = agent.figure;
  start.leaves = agent.leaves;
  if (agent.id < scene.agents.size()) start.route = scene.agents[agent.id].route;
  return start;
}

std::vector<Obstacle> obstaclesOf(const World& world) {
  std::vector<Obstacle> obstacles = world.obstacles();
  for (Obstacle& obstacle : obstacles) obstacle.path = obstacle.path.after(world.time());
  return obstacles;
}

bool isGate(const Segment& wall, const Scene& scene) {
  if (!scene.population) return false;
  const std::vector<GateDescription>& gates = scene.population->gates;
  return std::any_of(gates.begin(), gates.end(), [&](const GateDescription& gate) {
    return gate.wall.from == wall.from && gate.wall.to == wall.to;
  });
}

/// Writes the present walls. Gates are not among them, as the population has them.
void takeWalls(const World& world, bool with_map_file, Scene& scene) {
  const std::size_t map_walls = scene.walls.size() - scene.own_walls;
  const auto is_of_map = [&, end = scene.walls.size()](std::size_t id) { return id >= scene.own_walls && id < end; };
  const std::vector<std::size_t>& ids = world.walls().ids();
  const auto left = static_cast<std::size_t>(std::count_if(ids.begin(), ids.end(), is_of_map));
  const bool leaves_to_map = with_map_file && !scene.map_file.empty() && left == map_walls;
  std::vector<Segment> walls;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Segment& wall = world.walls().list()[i];
    if (!isGate(wall, scene) && !(leaves_to_map && is_of_map(ids[i]))) walls.push_back(wall);
  }
  if (!leaves_to_map) scene.map_file.clear();
  scene.walls = std::move(walls);
  scene.own_walls = scene.walls.size();
}

RobotStart startOf(const Robot& robot) {
  RobotStart start = robot.start;
  start.position = robot.pose.position;
  start.heading = robot.pose.heading;
  start.goals.clear();
  if (!robot.hasArrived() && robot.hasGoal()) {
    start.goals.assign(robot.goals.begin() + static_cast<std::ptrdiff_t>(robot.next_goal), robot.goals.end());
  }
  return start;
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

Scene sceneOnFloor(const Episode& episode, bool with_map_file) {
  const World& world = episode.world();
  Scene scene = episode.scene();
  std::vector<AgentStart> agents;
  std::map<AgentId, AgentId> numbers;  // in the new scene, by id
  std::map<GroupId, AgentId> first;    // new number of the first member of a group
  for (const Agent& agent : world.agents()) {
    if (!agent.isWalking()) continue;
    const auto number = static_cast<AgentId>(agents.size());
    numbers[agent.id] = number;
    agents.push_back(startOf(agent, scene));
    if (agent.group != NO_GROUP) agents.back().group = first.try_emplace(agent.group, number).first->second;
  }
  for (const auto& [id, number] : numbers) {
    std::optional<Leader> leader = episode.population().leaderOf(id);
    if (!leader) continue;
    if (leader->kind == Leader::Kind::AGENT) {
      const auto found = numbers.find(leader->number);
      if (found == numbers.end()) continue;  // removed since the last tick: Followers::update() releases others
      leader->number = found->second;
    }
    agents[number].leader = leader;
    agents[number].group = groupOf(*leader);
    if (leader->kind == Leader::Kind::AGENT) agents[leader->number].group = agents[number].group;
  }
  scene.agents = std::move(agents);
  scene.obstacles = obstaclesOf(world);
  for (RecordedPeople& entry : scene.recorded) entry.offset -= world.time();
  takeWalls(world, with_map_file, scene);
  scene.robots.clear();
  for (const Robot& robot : world.robots()) scene.robots.push_back(startOf(robot));
  return scene;
}

std::string leftOutText(const World& world) {
  const auto stays = [](const Agent& agent) { return agent.status == AgentStatus::STAYING; };
  const auto count = static_cast<std::size_t>(std::count_if(world.agents().begin(), world.agents().end(), stays));
  return count == 0 ? "" : ", without " + counted(count, "agent") + " at the last goal";
}

std::string countsText(const Scene& scene) {
  const auto is_recorded = [](const Obstacle& obstacle) { return obstacle.person.has_value(); };
  const auto recorded =
      static_cast<std::size_t>(std::count_if(scene.obstacles.begin(), scene.obstacles.end(), is_recorded));
  return counted(scene.agents.size(), "agent") + ", " + counted(scene.obstacles.size() - recorded, "obstacle") + ", " +
         (recorded == 0 ? "" : counted(recorded, "recorded walk") + ", ") + counted(scene.own_walls, "wall") +
         (scene.robots.empty() ? "" : ", " + counted(scene.robots.size(), "robot"));
}

}  // namespace crowd
