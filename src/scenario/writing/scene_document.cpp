#include "scenario/writing/scene_document.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <vector>

#include "common/text/numbers.h"
#include "scenario/population_spec.h"
#include "scenario/writing/kind_document.h"
#include "scenario/writing/population_document.h"
#include "scenario/writing/robot_document.h"

namespace crowd {
namespace {

std::string goalText(const AgentStart& agent, const Scene& scene) {
  if (agent.leader && agent.leader->kind == Leader::Kind::AGENT) {
    return "leader: " + std::to_string(agent.leader->number);
  }
  if (agent.leader) return "leader: {robot: " + quotedYaml(scene.robots[agent.leader->number].name) + "}";
  if (agent.route) return "route: " + quotedYaml(scene.population->routes[*agent.route].name);
  return "goals: " + pointsText(agent.goals);
}

std::string entryOf(const AgentStart& agent, const Scene& scene) {
  return "  - {position: " + pointText(agent.position) + ", " + goalText(agent, scene) +
         (agent.reaction_time > 0.0 ? ", reaction_time: " + toText(agent.reaction_time) : "") + kindText(agent, scene) +
         reactionText(agent) + ", speed: " + toText(agent.max_speed) +
         (agent.hurry != 1.0 ? ", hurry: " + toText(agent.hurry) : "") + ", radius: " + toText(agent.radius) +
         (agent.faces_goal ? "" : ", heading: " + headingText(agent.heading)) +
         (agent.velocity.isZero(0.0) ? "" : ", velocity: " + pointText(agent.velocity)) + "}\n";
}

std::string motionOf(const ObstaclePath& path) {
  using Kind = ObstaclePath::Kind;
  if (path.kind() == Kind::AT_REST) return "";
  if (path.kind() == Kind::STRAIGHT) return ", velocity: " + pointText(path.velocity(0.0));
  return (path.kind() == Kind::LOOP ? ", waypoints: " : ", to_and_fro: ") +
         pointsText({path.points().begin() + 1, path.points().end()}) + ", speed: " + toText(path.speed());
}

/// Recorded people are read from their recording again.
std::string entryOf(const Obstacle& obstacle) {
  if (obstacle.person) return "";
  return "  - {position: " + pointText(obstacle.path.position(0.0)) + ", radius: " + toText(obstacle.radius) +
         motionOf(obstacle.path) + "}\n";
}

std::string entryOf(const Segment& wall) { return "  - [" + pointText(wall.from) + ", " + pointText(wall.to) + "]\n"; }

std::string agentsText(const Scene& scene) {
  std::string text;
  for (const AgentStart& agent : scene.agents) text += entryOf(agent, scene);
  return text.empty() ? "" : "agents:\n" + text;
}

/// The groups whose members have goals of their own. A group of which one member is left is no group any more.
std::string groupsText(const Scene& scene) {
  std::map<GroupId, std::vector<std::size_t>> members;
  std::set<GroupId> led;
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    const AgentStart& agent = scene.agents[i];
    if (agent.group == NO_GROUP) continue;
    if (agent.leader) led.insert(agent.group);
    members[agent.group].push_back(i);
  }
  std::string text;
  for (const auto& [group, numbers] : members) {
    if (led.count(group) > 0 || numbers.size() < 2) continue;
    std::string list;
    for (const std::size_t number : numbers) list += (list.empty() ? "" : ", ") + std::to_string(number);
    text += "  - {members: [" + list + "]}\n";
  }
  return text.empty() ? "" : "groups:\n" + text;
}

/// The walls; those of a map that is read from its file are not among them.
std::string wallsText(const Scene& scene) {
  const std::size_t count = scene.map_file.empty() ? scene.walls.size() : scene.own_walls;
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += entryOf(scene.walls[i]);
  return text.empty() ? "" : "walls:\n" + text;
}

/// The radius of the largest agent that a reader of the document finds [m].
double largestRadius(const Scene& scene) {
  double radius = 0.0;
  for (const AgentStart& agent : scene.agents) radius = std::max(radius, agent.radius);
  if (!scene.population) return radius;
  for (const SourceDescription& source : scene.population->sources) {
    radius = std::max(radius, source.agents.radius.high);
  }
  return radius;
}

/// The path of a file, as a document in a folder names it.
std::string pathText(const std::string& file, const std::string& folder) {
  namespace fs = std::filesystem;
  return quotedYaml(fs::proximate(fs::absolute(file), fs::absolute(folder)).string());
}

std::string entryOf(const RecordedPeople& entry, const std::string& folder) {
  std::string text = "  - {file: " + pathText(entry.file, folder);
  if (entry.instance) text += ", instance: " + std::to_string(*entry.instance);
  if (entry.frame_rate) text += ", frame_rate: " + toText(*entry.frame_rate);
  if (entry.from != 0.0) text += ", from: " + toText(entry.from);
  if (entry.to) text += ", to: " + toText(*entry.to);
  if (entry.offset != 0.0) text += ", offset: " + toText(entry.offset);
  std::string people;
  for (const std::uint64_t person : entry.people) people += (people.empty() ? "" : ", ") + std::to_string(person);
  if (!people.empty()) text += ", people: [" + people + "]";
  if (!entry.shift.isZero(0.0)) text += ", shift: " + pointText(entry.shift);
  return text + ", radius: " + toText(entry.radius) + "}\n";
}

std::string recordedText(const Scene& scene, const std::string& folder) {
  std::string text;
  for (const RecordedPeople& entry : scene.recorded) text += entryOf(entry, folder);
  return text.empty() ? "" : "recorded:\n" + text;
}

std::string mapText(const Scene& scene, const std::string& folder) {
  if (scene.map_file.empty()) return "";
  const bool differs = scene.free_radius != largestRadius(scene);
  return "map: " + pathText(scene.map_file, folder) + "\n" +
         (differs ? "free_radius: " + toText(scene.free_radius) + "\n" : "");
}

template <typename Bodies>
std::string section(const std::string& key, const Bodies& bodies) {
  std::string text;
  for (const auto& body : bodies) text += entryOf(body);
  return text.empty() ? "" : key + ":\n" + text;
}

}  // namespace

std::string toDocument(const Scene& scene, const std::string& folder) {
  return "---\nname: " + quotedYaml(scene.name) + "\ntick: " + toText(scene.tick_duration) +
         "\nduration: " + toText(static_cast<double>(scene.max_ticks) * scene.tick_duration) +
         "\ngoal_tolerance: " + toText(scene.goal_tolerance) + "\n" +
         (scene.contact == Contact::SOLID ? "contact: solid\n" : "") +
         (scene.motion ? "motion: " + toText(*scene.motion) + "\n" : "") +
         (scene.order == Order::SEQUENTIAL ? "order: sequential\n" : "") +
         (scene.arrived == Arrived::STAY ? "arrived: stay\n" : "") +
         (scene.collision_radius != DEFAULT_COLLISION_RADIUS
              ? "collision_radius: " + toText(scene.collision_radius) + "\n"
              : "") +
         (scene.seed != 0 ? "seed: " + std::to_string(scene.seed) + "\n" : "") +
         (scene.way_finding ? "" : "way_finding: false\n") + mapText(scene, folder) + agentsText(scene) +
         groupsText(scene) + section("obstacles", scene.obstacles) + recordedText(scene, folder) + wallsText(scene) +
         robotsText(scene) + (scene.population ? populationText(*scene.population) : "") + kindsText(scene);
}

}  // namespace crowd
