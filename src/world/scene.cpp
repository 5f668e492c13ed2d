#include "social_crowd/world/scene.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace crowd {
namespace {

std::string name(const char* list, std::size_t index) { return std::string(list) + "[" + std::to_string(index) + "]"; }

std::string findOverlapOf(const Scene& scene, std::size_t index) {
  const AgentStart& agent = scene.agents[index];
  for (std::size_t i = index + 1; i < scene.agents.size(); ++i) {
    const AgentStart& other = scene.agents[i];
    const double depth = agent.radius + other.radius - (agent.position - other.position).norm();
    if (depth > TOUCH_TOLERANCE) {
      return overlapText(name("agents", index), name("agents", i), depth);
    }
  }
  for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
    const Vector2 centre = scene.obstacles[i].path.position(0.0);
    const double depth = agent.radius + scene.obstacles[i].radius - (agent.position - centre).norm();
    if (depth > TOUCH_TOLERANCE) {
      return overlapText(name("agents", index), name("obstacles", i), depth);
    }
  }
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const double depth = agent.radius - distanceTo(scene.walls[i], agent.position);
    if (depth > TOUCH_TOLERANCE) {
      return overlapText(name("agents", index), name("walls", i), depth);
    }
  }
  return {};
}

}  // namespace

void keepHeadings(const std::vector<double>& last, Scene& scene) {
  const std::size_t count = std::min(last.size(), scene.agents.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (scene.agents[i].keeps_heading) scene.agents[i].heading = last[i];
  }
}

std::string overlapText(const std::string& first, const std::string& second, double depth) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << first << " and " << second << " overlap by " << std::setprecision(3) << depth << " m";
  return text.str();
}

std::string findOverlap(const Scene& scene) {
  for (std::size_t i = 0; i < scene.agents.size(); ++i) {
    std::string overlap = findOverlapOf(scene, i);
    if (!overlap.empty()) {
      return overlap;
    }
  }
  return {};
}

}  // namespace crowd
