#include <algorithm>
#include <string>

#include "scenario/reading/facing_reader.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

using Kind = WaypointDescription::Kind;

/// Reads the waypoints of the routes of one document.
class RouteReader {
 public:
  explicit RouteReader(const PopulationDescription& population) : population_(population) {}

  RouteDescription read(const YAML::Node& node, const YamlPlace& place) const;

 private:
  WaypointDescription readWaypoint(const YAML::Node& node, const YamlPlace& place) const;
  WaypointDescription readAlternative(const YAML::Node& node, const YamlPlace& place) const;

  const PopulationDescription& population_;
};

bool isSink(const WaypointDescription& waypoint) {
  const auto& others = waypoint.alternatives;
  return waypoint.kind == Kind::SINK || waypoint.kind == Kind::NEAREST_SINK ||
         std::any_of(others.begin(), others.end(), isSink);
}

/// Reads the wait at a place, and where the agent looks in it.
void readStay(const YamlMap& map, WaypointDescription& waypoint) {
  for (const char* key : {"wait", "face"}) {
    if (map.has(key) && !map.has("place")) {
      throwProblem(map.placeOf(key), map.need(key), "a " + std::string(key) + " goes with a place only");
    }
  }
  if (map.has("wait")) waypoint.wait = readRange(map.need("wait"), map.placeOf("wait"), NumberRule::NOT_NEGATIVE);
  waypoint.face = readFacing(map);
  if (!waypoint.face || waypoint.wait.high > 0.0) return;
  throwProblem(map.placeOf("face"), map.need("face"), "a face goes with a wait only");
}

WaypointDescription RouteReader::readWaypoint(const YAML::Node& node, const YamlPlace& place) const {
  const YamlMap map(node, place, {"place", "wait", "face", "queue", "one_of", "sink"});
  WaypointDescription waypoint;
  waypoint.line = lineOf(node);
  const int kinds = map.has("place") + map.has("queue") + map.has("one_of") + map.has("sink");
  if (kinds != 1) throwProblem(place, node, "expected one of place, queue, one_of and sink");
  readStay(map, waypoint);
  if (map.has("place")) {
    waypoint.place = readRegion(map.need("place"), map.placeOf("place"));
  } else if (map.has("queue")) {
    waypoint.kind = Kind::QUEUE;
    waypoint.target = readNameOf(population_.queues, map, "queue");
  } else if (map.has("sink")) {
    const WaypointDescription sink = readSinkName(map, population_.sinks);
    waypoint.kind = sink.kind;
    waypoint.target = sink.target;
  } else {
    waypoint.kind = Kind::ONE_OF;
    const auto read = [this](const YAML::Node& entry, const YamlPlace& at) { return readAlternative(entry, at); };
    waypoint.alternatives = readList<WaypointDescription>(map.need("one_of"), map.placeOf("one_of"), read);
    if (waypoint.alternatives.empty()) {
      throwExpected(map.placeOf("one_of"), map.need("one_of"), "at least one waypoint");
    }
  }
  return waypoint;
}

WaypointDescription RouteReader::readAlternative(const YAML::Node& node, const YamlPlace& place) const {
  WaypointDescription waypoint = readWaypoint(node, place);
  if (waypoint.kind == Kind::ONE_OF) throwProblem(place, node, "expected a place, queue or sink, got another one_of");
  return waypoint;
}

RouteDescription RouteReader::read(const YAML::Node& node, const YamlPlace& place) const {
  const YamlMap map(node, place, {"repeat", "waypoints"});
  RouteDescription route;
  route.repeat = map.flag("repeat", false);
  const auto read = [this](const YAML::Node& entry, const YamlPlace& at) { return readWaypoint(entry, at); };
  const YAML::Node waypoints = map.need("waypoints");
  const YamlPlace at = map.placeOf("waypoints");
  route.waypoints = readList<WaypointDescription>(waypoints, at, read);
  if (route.waypoints.empty()) throwExpected(at, waypoints, "at least one waypoint");
  for (std::size_t i = 0; i + 1 < route.waypoints.size(); ++i) {
    if (!isSink(route.waypoints[i])) continue;
    throwProblem(at.element(i), waypoints[i], "expected a sink as the last waypoint only");
  }
  if (route.repeat && isSink(route.waypoints.back())) {
    throwProblem(at.element(route.waypoints.size() - 1), waypoints[route.waypoints.size() - 1],
                 "a route that repeats has no sink");
  }
  return route;
}

}  // namespace

std::vector<RouteDescription> readRoutes(const YamlMap& map, const PopulationDescription& population) {
  const RouteReader reader(population);
  const auto read = [&](const YAML::Node& node, const YamlPlace& place) { return reader.read(node, place); };
  return readNamed<RouteDescription>(map.find("routes"), map.placeOf("routes"), read);
}

}  // namespace crowd
