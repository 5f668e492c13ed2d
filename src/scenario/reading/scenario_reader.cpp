#include "scenario/reading/scenario_reader.h"

#include <cmath>
#include <limits>
#include <utility>

#include "scenario/population_checks.h"
#include "scenario/reading/agent_reader.h"
#include "scenario/reading/group_reader.h"
#include "scenario/reading/kind_reader.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/person_checks.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/recorded_reader.h"
#include "scenario/reading/region_reader.h"
#include "scenario/reading/robot_reader.h"
#include "scenario/reading/scenario_map.h"

namespace crowd {
namespace {

enum class UnitSystem { SI, THESIS };
constexpr EnumNames<UnitSystem, 2> UNIT_SYSTEMS{"units", {"si", "thesis"}};

constexpr std::int64_t MAX_AGENT = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t MAX_SEED = std::numeric_limits<std::int64_t>::max();

/// Reads a point or region, or a list of them: [x, y] is one point, [[x, y], ...] is a list.
std::vector<Region> readWaypoints(const YAML::Node& node, const YamlPlace& place) {
  const bool single = node.IsMap() || (node.IsSequence() && node.size() > 0 && node[0].IsScalar());
  return single ? std::vector<Region>{readRegion(node, place)} : readRegions(node, place);
}

void readMotion(const YamlMap& map, const Units& units, ObstacleGroup& group) {
  using Kind = ObstaclePath::Kind;
  const YAML::Node velocity = map.find("velocity");
  const YAML::Node to_and_fro = map.find("to_and_fro");
  const YAML::Node waypoints = map.find("waypoints");
  const YAML::Node speed = map.find("speed");
  if ((velocity ? 1 : 0) + (to_and_fro ? 1 : 0) + (waypoints ? 1 : 0) > 1) {
    throwProblem(map.place(), map.node(), "expected only one of velocity, to_and_fro and waypoints");
  }
  if (velocity) {
    group.velocity = readVector(velocity, map.placeOf("velocity"), units.limit(limits::VELOCITY));
    group.velocity = {units.speed(group.velocity.x()), units.speed(group.velocity.y())};
    group.motion = group.velocity.isZero(0.0) ? Kind::AT_REST : Kind::STRAIGHT;
  } else if (to_and_fro) {
    group.waypoints = readWaypoints(to_and_fro, map.placeOf("to_and_fro"));
    group.motion = Kind::TO_AND_FRO;
  } else if (waypoints) {
    group.waypoints = readWaypoints(waypoints, map.placeOf("waypoints"));
    group.motion = Kind::LOOP;
  }
  if (!group.waypoints.empty()) {
    group.speed = units.speed(readRange(map.need("speed"), map.placeOf("speed"), units.limit(limits::SPEED)));
  } else if (speed) {
    throwProblem(map.placeOf("speed"), speed, "a speed goes with to_and_fro or waypoints only");
  }
}

Between readBetween(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"agent", "share", "aside"});
  Between between;
  between.agent = static_cast<std::size_t>(map.whole("agent", 0, MAX_AGENT));
  between.share = readRange(map.need("share"), map.placeOf("share"), NumberRule::FRACTION);
  if (const YAML::Node aside = map.find("aside")) {
    between.aside = readRange(aside, map.placeOf("aside"), limits::PLACE);
  }
  return between;
}

void readPosition(const YamlMap& map, ObstacleGroup& group) {
  const YAML::Node position = map.need("position");
  const YamlPlace place = map.placeOf("position");
  if (const YAML::Node between = findOnly("between", position, place)) {
    group.between = readBetween(between, place.child("between"));
    return;
  }
  group.position = readRegion(position, place, "[x, y], {box: ...}, {ring: ...}, {map: free} or {between: ...}");
}

ObstacleGroup readObstacles(const YAML::Node& node, const YamlPlace& place, const Units& units) {
  const YamlMap map(node, place, {"position", "radius", "count", "velocity", "to_and_fro", "waypoints", "speed"});
  ObstacleGroup group;
  group.line = lineOf(node);
  readPosition(map, group);
  group.radius = readRange(map.need("radius"), map.placeOf("radius"), limits::RADIUS);
  group.count = readBodyCount(map, group.between ? group.between->isFixed() : group.position.isFixed());
  readMotion(map, units, group);
  return group;
}

std::uint64_t readDuration(const YamlMap& map, const Units& units) {
  const double duration = map.number("duration", NumberRule::POSITIVE);
  // A whole number of ticks must not lose one tick to rounding.
  const double ticks = std::floor((units.thesis ? duration : duration / units.tick_duration) + 1e-6);
  if (ticks < 1.0 || ticks > limits::TICKS || ticks * units.tick_duration > limits::DURATION) {
    throwExpected(map.placeOf("duration"), map.need("duration"), "a duration of 1 to 1e9 ticks, at most 1e9 s");
  }
  return static_cast<std::uint64_t>(ticks);
}

/// @param key of the list of the groups
template <typename Groups>
void requireFewBodies(const YamlMap& map, const std::string& key, const Groups& groups) {
  std::size_t count = 0;
  for (const auto& group : groups) count += static_cast<std::size_t>(group.count);
  if (count <= limits::BODIES) return;
  throwProblem(map.placeOf(key), map.need(key),
               "expected at most " + std::to_string(limits::BODIES) + " in all, got " + std::to_string(count));
}

/// Reads `agents`; a scenario with sources, robots or recorded people may have none.
void readCrowd(const YamlMap& map, const Units& units, const PopulationDescription& population, Scenario& scenario) {
  const auto read = [&](const YAML::Node& entry, const YamlPlace& at) {
    return readAgents(entry, at, units, population);
  };
  const bool optional = !population.sources.empty() || !scenario.robots.empty() || !scenario.recorded.empty();
  scenario.agents =
      readList<AgentGroup>(optional ? map.find("agents") : map.need("agents"), map.placeOf("agents"), read);
  if (scenario.agents.empty() && !optional) {
    throwExpected(map.placeOf("agents"), map.need("agents"), "at least one agent");
  }
  requireFewBodies(map, "agents", scenario.agents);
}

Scenario readScenario(const YAML::Node& node, const YamlPlace& place, double& reach_points, const StopRequest& stop) {
  const YamlMap map(node, place,
                    {"name",     "units",       "tick",        "duration", "goal_tolerance", "collision_radius",
                     "contact",  "order",       "seed",        "agents",   "obstacles",      "walls",
                     "map",      "free_radius", "way_finding", "routes",   "sources",        "sinks",
                     "queues",   "gates",       "robots",      "ends",     "motion",         "groups",
                     "recorded", "kinds",       "attractions", "alarms",   "arrived"});
  Scenario scenario;
  scenario.source = place.file + ": document " + std::to_string(place.document);
  scenario.name = map.text("name");
  if (scenario.name.empty()) {
    throwExpected(map.placeOf("name"), map.need("name"), "a name");
  }
  const Units units{UNIT_SYSTEMS.read(map, UnitSystem::SI) == UnitSystem::THESIS,
                    map.number("tick", limits::TICK, DEFAULT_TICK_DURATION)};
  scenario.tick_duration = units.tick_duration;
  scenario.max_ticks = readDuration(map, units);
  scenario.goal_tolerance = map.number("goal_tolerance", limits::DISTANCE);
  scenario.collision_radius = map.number("collision_radius", limits::RADIUS, DEFAULT_COLLISION_RADIUS);
  scenario.contact = CONTACTS.read(map, Contact::GHOST);
  if (map.has("motion")) scenario.motion = readMotionLimits(map.find("motion"), map.placeOf("motion"));
  scenario.order = ORDERS.read(map, Order::SIMULTANEOUS);
  scenario.seed = static_cast<std::uint64_t>(map.whole("seed", 0, MAX_SEED, 0));
  PopulationDescription population = readPopulation(map);
  population.kinds = readKinds(map, units);
  population.sources = readSources(map, units, population);
  scenario.robots = readRobots(map, units, scenario.goal_tolerance, population);
  scenario.ends = ENDS.read(map, Ends::ALL);
  if (scenario.ends == Ends::ROBOTS && scenario.robots.empty()) {
    throwProblem(map.placeOf("ends"), map.need("ends"), "there are no robots");
  }
  scenario.arrived = ARRIVALS.read(map, Arrived::LEAVE);
  scenario.recorded = readRecorded(map, scenario.tick_duration);
  readCrowd(map, units, population, scenario);
  keepUsedKinds(scenario.agents, population);
  scenario.groups = readGroups(map);
  resolveGroups(scenario, map.place());
  const auto obstacles = [&](const YAML::Node& entry, const YamlPlace& at) { return readObstacles(entry, at, units); };
  scenario.obstacles = readList<ObstacleGroup>(map.find("obstacles"), map.placeOf("obstacles"), obstacles);
  requireFewBodies(map, "obstacles", scenario.obstacles);
  scenario.walls = readList<Segment>(map.find("walls"), map.placeOf("walls"), readWall);
  scenario.way_finding = map.flag("way_finding", true);
  if (!population.empty() || !population.kinds.empty()) {
    scenario.population = std::make_shared<const PopulationDescription>(std::move(population));
  }
  readScenarioMap(map, scenario, reach_points, stop);
  if (scenario.population) checkPopulation(scenario);
  if (!units.thesis) scenario.warnings = findUnlikelyPeople(scenario);
  return scenario;
}

// Grid points of FloorReach for all scenarios of a file, 8 bytes each: enough for four floors of the largest size, and
// for each scenario for one of 5000 m2.
constexpr double REACH_POINTS = 6.4e7;
constexpr double REACH_POINTS_EACH = 2e6;

ScenarioList readStream(const std::vector<YAML::Node>& documents, const std::string& name,
                        const StopRequest& stop = {}) {
  if (documents.empty()) {
    throw InputError(name + ": expected at least one scenario, got an empty file");
  }
  double reach_points = REACH_POINTS;
  std::vector<Scenario> scenarios;
  scenarios.reserve(documents.size());
  for (const YAML::Node& document : documents) {
    reach_points += REACH_POINTS_EACH;
    scenarios.push_back(readScenario(document, {name, static_cast<int>(scenarios.size()) + 1, ""}, reach_points, stop));
    scenarios.back().instantiate(0, 0, stop);  // reports overlaps and lack of space now instead of during a run
  }
  return ScenarioList(std::move(scenarios));
}

}  // namespace

ScenarioList readScenarios(const std::string& file, const StopRequest& stop, FileKinds kinds) {
  return readStream(loadYamlStream(file, kinds), file, stop);
}

ScenarioList readScenarios(const std::vector<std::string>& files, const StopRequest& stop) {
  std::vector<Scenario> all;
  for (const std::string& file : files) {
    const ScenarioList scenarios = readScenarios(file, stop);
    for (std::size_t i = 0; i < scenarios.size(); ++i) all.push_back(scenarios[i]);
  }
  return ScenarioList(std::move(all));
}

ScenarioList parseScenarios(const std::string& text, const std::string& name) {
  return readStream(parseYamlStream(text, name), name);
}

}  // namespace crowd
