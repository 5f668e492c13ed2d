#include "scenario/reading/agent_reader.h"

#include <string>

#include "common/text/numbers.h"
#include "scenario/reading/group_reader.h"
#include "scenario/reading/kind_reader.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

void readGoals(const YamlMap& map, const PopulationDescription& population, AgentGroup& group) {
  if (group.leader) return;
  if (const YAML::Node route = map.find("route")) {
    if (map.has("goal") || map.has("goals")) {
      throwProblem(map.place(), route, "expected only one of goal, goals and route");
    }
    group.route = readNameOf(population.routes, map, "route");
    return;
  }
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
    group.opposite = readVector(opposite, place.child("opposite"), limits::PLACE);
    return;
  }
  group.goals = {readRegion(goal, place, "[x, y], {box: ...}, {ring: ...}, {map: free} or {opposite: [x, y]}")};
}

/// Reads `goal`, `random`, `kept`, degrees, or {radians: ANGLE}.
void readFirstHeading(const YamlMap& map, AgentGroup& group) {
  const YAML::Node node = map.find("heading");
  const std::string word = node && node.IsScalar() ? node.Scalar() : "";
  if (!node || word == "goal") return;
  group.keeps_heading = word == "kept";
  if (group.keeps_heading) return;
  if (word == "random") {
    group.heading = Range{-PI, PI};
    return;
  }
  const YamlPlace place = map.placeOf("heading");
  const bool is_number = word.find_first_of("0123456789") != std::string::npos;
  if (node.IsScalar() && !is_number) {
    throwExpected(place, node, "goal, random, kept, or degrees: a number or [low, high]");
  }
  group.heading = readHeading(node, place);
}

void readFirstVelocity(const YamlMap& map, const Units& units, AgentGroup& group) {
  const YAML::Node node = map.find("velocity");
  if (!node) return;
  const YamlPlace place = map.placeOf("velocity");
  const Vector2 velocity = readVector(node, place, units.limit(limits::VELOCITY));
  group.velocity = {units.speed(velocity.x()), units.speed(velocity.y())};
  if (group.velocity.norm() > group.max_speed.low * group.hurry.low)
    throwExpected(place, node,
                  map.has("hurry") ? "a velocity of at most `speed` times `hurry`" : "a velocity of at most `speed`");
}

}  // namespace

void readWalk(const YamlMap& map, const Units& units, const PopulationDescription& population, AgentGroup& group) {
  readGoals(map, population, group);
  readKindsOf(map, population.kinds, group);
  readReactions(map, group);
  group.speed_of_kind = map.has("kind") && !map.has("speed");
  group.radius_of_kind = map.has("kind") && !map.has("radius");
  if (!group.speed_of_kind) {
    group.max_speed = units.speed(readRange(map.need("speed"), map.placeOf("speed"), units.limit(limits::SPEED)));
  }
  if (!group.radius_of_kind) group.radius = readRange(map.need("radius"), map.placeOf("radius"), limits::RADIUS);
  const YAML::Node hurry = map.find("hurry");
  if (!hurry) return;
  group.hurry = readRange(hurry, map.placeOf("hurry"), limits::PACE);
  if (group.max_speed.high * group.hurry.high <= limits::SPEED.most) return;
  throwExpected(map.placeOf("hurry"), hurry,
                "a factor with which `speed` is at most " + toText(limits::SPEED.most) + " m/s");
}

AgentGroup readAgents(const YAML::Node& node, const YamlPlace& place, const Units& units,
                      const PopulationDescription& population) {
  const YamlMap map(node, place,
                    {"position", "goal", "goals", "route", "kind", "speed", "hurry", "radius", "heading", "velocity",
                     "reaction", "reaction_time", "count", "leader", "groups"});
  AgentGroup group;
  group.line = lineOf(node);
  group.position = readRegion(map.need("position"), map.placeOf("position"));
  if (map.has("leader")) {
    for (const char* key : {"goal", "goals", "route", "groups"}) {
      if (map.has(key)) throwProblem(map.placeOf(key), map.need(key), "goes without `leader` only");
    }
    group.leader = readLeader(map);
  }
  readWalk(map, units, population, group);
  group.groups = readGroupShare(map);
  readFirstHeading(map, group);
  readFirstVelocity(map, units, group);
  if (const YAML::Node reaction = map.find("reaction_time")) {
    group.reaction_time = readRange(reaction, map.placeOf("reaction_time"), NumberRule::NOT_NEGATIVE);
  }
  group.count = readBodyCount(map, group.position.isFixed());
  return group;
}

}  // namespace crowd
