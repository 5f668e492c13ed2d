#include "social_crowd/world/scene_document.h"

#include "social_crowd/common/numbers.h"
#include "world/population_document.h"

namespace crowd {
namespace {

std::string listText(std::vector<Vector2>::const_iterator begin, std::vector<Vector2>::const_iterator end) {
  std::string text;
  for (auto point = begin; point != end; ++point) text += (text.empty() ? "" : ", ") + pointText(*point);
  return "[" + text + "]";
}

std::string goalText(const AgentStart& agent, const Scene& scene) {
  if (agent.route) return "route: " + quoted(scene.population->routes[*agent.route].name);
  return "goals: " + listText(agent.goals.begin(), agent.goals.end());
}

std::string entryOf(const AgentStart& agent, const Scene& scene) {
  return "  - {position: " + pointText(agent.position) + ", " + goalText(agent, scene) +
         (agent.reaction_time > 0.0 ? ", reaction_time: " + toText(agent.reaction_time) : "") +
         ", speed: " + toText(agent.max_speed) + ", radius: " + toText(agent.radius) +
         (agent.faces_goal ? "" : ", heading: " + toText(toDegrees(agent.heading))) + "}\n";
}

std::string motionOf(const ObstaclePath& path) {
  using Kind = ObstaclePath::Kind;
  if (path.kind() == Kind::AT_REST) return "";
  if (path.kind() == Kind::STRAIGHT) return ", velocity: " + pointText(path.velocity(0.0));
  return (path.kind() == Kind::LOOP ? ", waypoints: " : ", to_and_fro: ") +
         listText(path.points().begin() + 1, path.points().end()) + ", speed: " + toText(path.velocity(0.0).norm());
}

std::string entryOf(const Obstacle& obstacle) {
  return "  - {position: " + pointText(obstacle.path.position(0.0)) + ", radius: " + toText(obstacle.radius) +
         motionOf(obstacle.path) + "}\n";
}

std::string entryOf(const Segment& wall) { return "  - [" + pointText(wall.from) + ", " + pointText(wall.to) + "]\n"; }

std::string agentsText(const Scene& scene) {
  std::string text;
  for (const AgentStart& agent : scene.agents) text += entryOf(agent, scene);
  return text.empty() ? "" : "agents:\n" + text;
}

template <typename Bodies>
std::string section(const std::string& key, const Bodies& bodies) {
  std::string text;
  for (const auto& body : bodies) text += entryOf(body);
  return text.empty() ? "" : key + ":\n" + text;
}

}  // namespace

std::string toDocument(const Scene& scene) {
  return "---\nname: " + quoted(scene.name) + "\ntick: " + toText(scene.tick_duration) +
         "\nduration: " + toText(static_cast<double>(scene.max_ticks) * scene.tick_duration) +
         "\ngoal_tolerance: " + toText(scene.goal_tolerance) + "\n" +
         (scene.contact == Contact::SOLID ? "contact: solid\n" : "") +
         (scene.order == Order::SEQUENTIAL ? "order: sequential\n" : "") +
         (scene.collision_radius != DEFAULT_COLLISION_RADIUS
              ? "collision_radius: " + toText(scene.collision_radius) + "\n"
              : "") +
         agentsText(scene) + section("obstacles", scene.obstacles) + section("walls", scene.walls) +
         (scene.population ? populationText(*scene.population) : "");
}

}  // namespace crowd
