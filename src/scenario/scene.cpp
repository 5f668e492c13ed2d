#include "scenario/scene.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace crowd {

void keepHeadings(const std::vector<double>& last, Scene& scene) {
  const std::size_t count = std::min(last.size(), scene.agents.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (scene.agents[i].keeps_heading) scene.agents[i].heading = last[i];
  }
}

std::string nameOf(const Obstacle& obstacle, std::size_t number) {
  return obstacle.person ? "recorded person " + std::to_string(*obstacle.person) : "obstacle " + std::to_string(number);
}

std::string overlapText(const std::string& first, const std::string& second, double depth) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << first << " and " << second << " overlap by " << std::setprecision(3) << depth << " m";
  return text.str();
}

}  // namespace crowd
