#include "scenario/reading/scenario_map.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>

#include "common/text/numbers.h"
#include "maps/agent_size.h"
#include "maps/map_file.h"
#include "maps/map_walls.h"
#include "scenario/population_spec.h"

namespace crowd {
namespace {

/// Calls work(group) for the agents of the scenario and of its sources.
template <typename Work>
void forEachGroup(const Scenario& scenario, const Work& work) {
  for (const AgentGroup& group : scenario.agents) work(group);
  if (!scenario.population) return;
  for (const SourceDescription& source : scenario.population->sources) work(source.agents);
}

/// The radius of the largest agent [m].
double largestRadius(const Scenario& scenario) {
  double radius = 0.0;
  forEachGroup(scenario, [&](const AgentGroup& group) { radius = std::max(radius, group.radius.high); });
  return radius;
}

bool isFree(const Region& region) { return region.kind == Region::Kind::FREE; }

bool routeUsesFreeSpace(const std::vector<WaypointDescription>& waypoints) {
  return std::any_of(waypoints.begin(), waypoints.end(), [](const WaypointDescription& waypoint) {
    return isFree(waypoint.place) || routeUsesFreeSpace(waypoint.alternatives);
  });
}

bool usesFreeSpace(const Scenario& scenario) {
  bool uses = false;
  forEachGroup(scenario, [&](const AgentGroup& group) {
    uses = uses || isFree(group.position) || std::any_of(group.goals.begin(), group.goals.end(), isFree);
  });
  for (const ObstacleGroup& group : scenario.obstacles) uses = uses || isFree(group.position);
  for (const RobotGroup& group : scenario.robots) {
    uses = uses || isFree(group.position) || std::any_of(group.goals.begin(), group.goals.end(), isFree);
  }
  if (!scenario.population) return uses;
  const auto& routes = scenario.population->routes;
  return uses || std::any_of(routes.begin(), routes.end(),
                             [](const RouteDescription& route) { return routeUsesFreeSpace(route.waypoints); });
}

/// Adds where the scenario names the map to errors of its files.
OccupancyMap readMapOf(const std::string& name, const YamlMap& map) {
  try {
    return readMap(name);
  } catch (const Error& error) {
    throwProblem(map.placeOf("map"), map.need("map"), error.what());
  }
}

/// @param largest radius of all agents [m]
double readFreeRadius(const YamlMap& map, double largest) {
  const double radius = map.number("free_radius", NumberRule::POSITIVE, largest);
  if (radius >= largest) return radius;
  throwExpected(map.placeOf("free_radius"), map.need("free_radius"),
                "at least the radius of the largest agent, " + toText(largest) + " m");
}

bool drawsPlaces(const AgentGroup& group) {
  const auto is_drawn = [](const Region& region) { return !region.isFixed(); };
  if (group.route) return false;
  return is_drawn(group.position) || std::any_of(group.goals.begin(), group.goals.end(), is_drawn);
}

/// Lets agents be drawn where a way connects their places, if they find ways.
void addReach(Scenario& scenario, double& points_left, const StopRequest& stop) {
  FloorPlan floor;
  floor.walls = scenario.walls;
  if (scenario.map_walls) floor.walls.insert(floor.walls.end(), scenario.map_walls->begin(), scenario.map_walls->end());
  if (!scenario.way_finding || floor.walls.empty()) return;
  const double points = FloorReach::pointsOf(floor);
  if (points >= static_cast<double>(ClearanceGrid::MAX_POINTS)) return;
  std::map<double, std::shared_ptr<const FloorReach>> by_size;
  for (AgentGroup& group : scenario.agents) {
    if (!drawsPlaces(group)) continue;
    const double size = sizeOf(group.radius.high);
    std::shared_ptr<const FloorReach>& reach = by_size[size];
    if (!reach && points <= points_left) {
      points_left -= points;
      reach = std::make_shared<const FloorReach>(floor, size, stop);
    }
    group.reach = reach;
  }
}

/// Reads the map and, if places are drawn on it, its free space.
void readMapKeys(const YamlMap& map, Scenario& scenario, const StopRequest& stop) {
  const YAML::Node file = map.find("map");
  if (!file) {
    if (usesFreeSpace(scenario)) throwProblem(map.place(), map.node(), "{map: free} needs a map, got none");
    if (map.has("free_radius"))
      throwProblem(map.placeOf("free_radius"), map.need("free_radius"), "goes with a map only");
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(map.place().file).parent_path();
  const std::string name = (folder / map.text("map")).string();
  scenario.map_file = name;
  scenario.free_radius = readFreeRadius(map, largestRadius(scenario));
  scenario.map = std::make_shared<const OccupancyMap>(readMapOf(name, map));
  FloorPlan floor;
  floor.walls = traceWalls(*scenario.map);
  scenario.map_walls = std::make_shared<const std::vector<Segment>>(floor.walls);
  if (!usesFreeSpace(scenario)) return;
  floor.walls.insert(floor.walls.end(), scenario.walls.begin(), scenario.walls.end());
  scenario.free_space = std::make_shared<const FreeSpace>(*scenario.map, floor, scenario.free_radius, stop);
  if (scenario.free_space->empty()) {
    throwProblem(map.placeOf("map"), file, name + ": no agent of the scenario fits anywhere on the map");
  }
}

}  // namespace

void readScenarioMap(const YamlMap& map, Scenario& scenario, double& reach_points, const StopRequest& stop) {
  readMapKeys(map, scenario, stop);
  addReach(scenario, reach_points, stop);
}

}  // namespace crowd
