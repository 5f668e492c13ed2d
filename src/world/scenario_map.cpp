#include "world/scenario_map.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "social_crowd/world/map_file.h"
#include "social_crowd/world/map_walls.h"

namespace crowd {
namespace {

/// The radius of the largest agent [m].
double largestRadius(const Scenario& scenario) {
  double radius = 0.0;
  for (const AgentGroup& group : scenario.agents) radius = std::max(radius, group.radius.high);
  return radius;
}

bool usesFreeSpace(const Scenario& scenario) {
  const auto is_free = [](const Region& region) { return region.kind == Region::Kind::FREE; };
  const auto agents_use = [&](const AgentGroup& group) {
    return is_free(group.position) || std::any_of(group.goals.begin(), group.goals.end(), is_free);
  };
  const auto obstacles_use = [&](const ObstacleGroup& group) { return is_free(group.position); };
  return std::any_of(scenario.agents.begin(), scenario.agents.end(), agents_use) ||
         std::any_of(scenario.obstacles.begin(), scenario.obstacles.end(), obstacles_use);
}

}  // namespace

void readScenarioMap(const YamlMap& map, Scenario& scenario) {
  const YAML::Node file = map.find("map");
  if (!file) {
    if (usesFreeSpace(scenario)) throwProblem(map.place(), map.node(), "{map: free} needs a map, got none");
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(map.place().file).parent_path();
  const std::string name = (folder / map.text("map")).string();
  scenario.map = std::make_shared<const OccupancyMap>(readMap(name));
  FloorPlan floor;
  floor.walls = traceWalls(*scenario.map);
  scenario.map_walls = std::make_shared<const std::vector<Segment>>(floor.walls);
  if (!usesFreeSpace(scenario)) return;
  floor.walls.insert(floor.walls.end(), scenario.walls.begin(), scenario.walls.end());
  scenario.free_space = std::make_shared<const FreeSpace>(*scenario.map, floor, largestRadius(scenario));
  if (scenario.free_space->empty()) {
    throwProblem(map.placeOf("map"), file, name + ": no agent of the scenario fits anywhere on the map");
  }
}

}  // namespace crowd
