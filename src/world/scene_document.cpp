#include "social_crowd/world/scene_document.h"

#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

std::string pointText(const Vector2& point) { return "[" + toText(point.x()) + ", " + toText(point.y()) + "]"; }

std::string listText(std::vector<Vector2>::const_iterator begin, std::vector<Vector2>::const_iterator end) {
  std::string text;
  for (auto point = begin; point != end; ++point) text += (text.empty() ? "" : ", ") + pointText(*point);
  return "[" + text + "]";
}

/// A text as a single-quoted YAML scalar.
std::string quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "''" : std::string(1, letter);
  return quoted + "'";
}

std::string entryOf(const AgentStart& agent) {
  return "  - {position: " + pointText(agent.position) +
         ", goals: " + listText(agent.goals.begin(), agent.goals.end()) + ", speed: " + toText(agent.max_speed) +
         ", radius: " + toText(agent.radius) + ", heading: " + toText(toDegrees(agent.heading)) + "}\n";
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
         section("agents", scene.agents) + section("obstacles", scene.obstacles) + section("walls", scene.walls);
}

}  // namespace crowd
