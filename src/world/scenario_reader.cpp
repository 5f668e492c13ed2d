#include "social_crowd/world/scenario_reader.h"

#include <cmath>
#include <limits>
#include <utility>

#include "world/region_reader.h"
#include "world/scenario_map.h"

namespace crowd {
namespace {

enum class UnitSystem { SI, THESIS };
constexpr EnumNames<UnitSystem, 2> UNIT_SYSTEMS{"units", {"si", "thesis"}};

constexpr double MAX_TICKS = 1e9;
constexpr std::int64_t MAX_COUNT = 10000;
constexpr std::int64_t MAX_AGENT = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t MAX_SEED = std::numeric_limits<std::int64_t>::max();

/// Conversion from the units of a document (thesis: per tick, ticks) to SI.
struct Units {
  bool thesis = false;
  double tick_duration = DEFAULT_TICK_DURATION;

  double speed(double value) const { return thesis ? value / tick_duration : value; }
  Range speed(const Range& range) const { return {speed(range.low), speed(range.high)}; }
};

int lineOf(const YAML::Node& node) { return node.Mark().line + 1; }

void readGoals(const YamlMap& map, AgentGroup& group) {
  const YAML::Node goals = map.find("goals");
  if (goals && map.has("goal")) {
    throwProblem(map.place(), goals, "expected either goal or goals, got both");
  }
  if (goals) {
    group.goals = readRegions(goals, map.placeOf("goals"));
    return;
  }
  const YAML::Node goal = map.need("goal");
  const YamlPlace place = map.placeOf("goal");
  if (const YAML::Node opposite = findOnly("opposite", goal, place)) {
    group.opposite = readVector(opposite, place.child("opposite"));
    return;
  }
  group.goals = {readRegion(goal, place, "[x, y], {box: ...}, {ring: ...}, {map: free} or {opposite: [x, y]}")};
}

int readCount(const YamlMap& map, bool is_fixed) {
  const auto count = static_cast<int>(map.whole("count", 1, MAX_COUNT, 1));
  if (count > 1 && is_fixed) {
    throwProblem(map.placeOf("count"), map.need("count"), "more than one body needs a region as position");
  }
  return count;
}

/// Reads `goal`, `random`, `kept`, or degrees.
void readHeading(const YamlMap& map, AgentGroup& group) {
  const YAML::Node node = map.find("heading");
  const std::string word = node && node.IsScalar() ? node.Scalar() : "";
  if (!node || word == "goal") return;
  group.keeps_heading = word == "kept";
  if (group.keeps_heading) return;
  const YamlPlace place = map.placeOf("heading");
  const bool is_number = word.find_first_of("0123456789") != std::string::npos;
  if (node.IsScalar() && word != "random" && !is_number) {
    throwExpected(place, node, "goal, random, kept, or degrees: a number or [low, high]");
  }
  const Range degrees = word == "random" ? Range{-180.0, 180.0} : readRange(node, place, NumberRule::ANY);
  group.heading = Range{toRadians(degrees.low), toRadians(degrees.high)};
}

AgentGroup readAgents(const YAML::Node& node, const YamlPlace& place, const Units& units) {
  const YamlMap map(node, place, {"position", "goal", "goals", "speed", "radius", "heading", "count"});
  AgentGroup group;
  group.line = lineOf(node);
  group.position = readRegion(map.need("position"), map.placeOf("position"));
  readGoals(map, group);
  group.max_speed = units.speed(readRange(map.need("speed"), map.placeOf("speed"), NumberRule::POSITIVE));
  group.radius = readRange(map.need("radius"), map.placeOf("radius"), NumberRule::POSITIVE);
  readHeading(map, group);
  group.count = readCount(map, group.position.isFixed());
  return group;
}

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
    group.velocity = readVector(velocity, map.placeOf("velocity"));
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
    group.speed = units.speed(readRange(map.need("speed"), map.placeOf("speed"), NumberRule::POSITIVE));
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
    between.aside = readRange(aside, map.placeOf("aside"), NumberRule::ANY);
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
  group.radius = readRange(map.need("radius"), map.placeOf("radius"), NumberRule::POSITIVE);
  group.count = readCount(map, group.between ? group.between->isFixed() : group.position.isFixed());
  readMotion(map, units, group);
  return group;
}

Segment readWall(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() != 2) {
    throwExpected(place, node, "two ends [[x1, y1], [x2, y2]]");
  }
  Segment wall{readVector(node[0], place.element(0)), readVector(node[1], place.element(1))};
  if (wall.from == wall.to) {
    throwProblem(place, node, "expected a wall with a length, got twice the same end");
  }
  return wall;
}

/// Applies `read` to each element of a list; an absent or null list is empty.
template <typename T, typename Read>
std::vector<T> readList(const YAML::Node& node, const YamlPlace& place, Read read) {
  std::vector<T> list;
  if (!node || node.IsNull()) {
    return list;
  }
  if (!node.IsSequence()) {
    throwExpected(place, node, "a list");
  }
  list.reserve(node.size());
  for (const YAML::Node& element : node) {
    list.push_back(read(element, place.element(list.size())));
  }
  return list;
}

std::uint64_t readDuration(const YamlMap& map, const Units& units) {
  const double duration = map.number("duration", NumberRule::POSITIVE);
  // A whole number of ticks must not lose one tick to rounding.
  const double ticks = std::floor((units.thesis ? duration : duration / units.tick_duration) + 1e-6);
  if (ticks < 1.0 || ticks > MAX_TICKS) {
    throwExpected(map.placeOf("duration"), map.need("duration"), "a duration of 1 to 1e9 ticks");
  }
  return static_cast<std::uint64_t>(ticks);
}

Scenario readScenario(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place,
                    {"name", "units", "tick", "duration", "goal_tolerance", "collision_radius", "contact", "order",
                     "seed", "agents", "obstacles", "walls", "map", "way_finding"});
  Scenario scenario;
  scenario.source = place.file + ": document " + std::to_string(place.document);
  scenario.name = map.text("name");
  if (scenario.name.empty()) {
    throwExpected(map.placeOf("name"), map.need("name"), "a name");
  }
  const Units units{UNIT_SYSTEMS.read(map, UnitSystem::SI) == UnitSystem::THESIS,
                    map.number("tick", NumberRule::POSITIVE, DEFAULT_TICK_DURATION)};
  scenario.tick_duration = units.tick_duration;
  scenario.max_ticks = readDuration(map, units);
  scenario.goal_tolerance = map.number("goal_tolerance", NumberRule::POSITIVE);
  scenario.collision_radius = map.number("collision_radius", NumberRule::POSITIVE, DEFAULT_COLLISION_RADIUS);
  scenario.contact = CONTACTS.read(map, Contact::GHOST);
  scenario.order = ORDERS.read(map, Order::SIMULTANEOUS);
  scenario.seed = static_cast<std::uint64_t>(map.whole("seed", 0, MAX_SEED, 0));
  const auto agents = [&](const YAML::Node& entry, const YamlPlace& at) { return readAgents(entry, at, units); };
  scenario.agents = readList<AgentGroup>(map.need("agents"), map.placeOf("agents"), agents);
  if (scenario.agents.empty()) {
    throwExpected(map.placeOf("agents"), map.need("agents"), "at least one agent");
  }
  const auto obstacles = [&](const YAML::Node& entry, const YamlPlace& at) { return readObstacles(entry, at, units); };
  scenario.obstacles = readList<ObstacleGroup>(map.find("obstacles"), map.placeOf("obstacles"), obstacles);
  scenario.walls = readList<Segment>(map.find("walls"), map.placeOf("walls"), readWall);
  scenario.way_finding = map.flag("way_finding", true);
  readScenarioMap(map, scenario);
  return scenario;
}

ScenarioList readStream(const std::vector<YAML::Node>& documents, const std::string& name) {
  if (documents.empty()) {
    throw InputError(name + ": expected at least one scenario, got an empty file");
  }
  std::vector<Scenario> scenarios;
  scenarios.reserve(documents.size());
  for (const YAML::Node& document : documents) {
    scenarios.push_back(readScenario(document, {name, static_cast<int>(scenarios.size()) + 1, ""}));
    scenarios.back().instantiate(0, 0);  // reports overlaps and lack of space now instead of during a run
  }
  return ScenarioList(std::move(scenarios));
}

}  // namespace

ScenarioList readScenarios(const std::string& file) { return readStream(loadYamlStream(file), file); }

ScenarioList readScenarios(const std::vector<std::string>& files) {
  std::vector<Scenario> all;
  for (const std::string& file : files) {
    const ScenarioList scenarios = readScenarios(file);
    for (std::size_t i = 0; i < scenarios.size(); ++i) all.push_back(scenarios[i]);
  }
  return ScenarioList(std::move(all));
}

ScenarioList parseScenarios(const std::string& text, const std::string& name) {
  return readStream(parseYamlStream(text, name), name);
}

}  // namespace crowd
