#include "scenario/writing/population_document.h"

#include <cmath>

#include "common/text/numbers.h"
#include "scenario/writing/kind_document.h"

namespace crowd {
namespace {

using Kind = WaypointDescription::Kind;

std::string regionText(const Region& region) {
  if (region.kind == Region::Kind::FREE) return "{map: free}";
  if (region.kind == Region::Kind::BOX) {
    return "{box: [" + pointText(region.first) + ", " + pointText(region.second) + "]}";
  }
  if (region.kind == Region::Kind::RING) {
    return "{ring: {centre: " + pointText(region.first) + ", radius: " + rangeText(region.radius) + "}}";
  }
  return pointText(region.first);
}

/// ", KEY: VALUE", or nothing if it is the default.
std::string optionalText(const std::string& key, const Range& range, const Range& otherwise = {}) {
  const bool is_default = range.low == otherwise.low && range.high == otherwise.high;
  return is_default ? "" : ", " + key + ": " + rangeText(range);
}

std::string faceText(const std::optional<FacingDescription>& face) {
  using FaceKind = FacingDescription::Kind;
  if (!face) return "";
  if (face->kind == FaceKind::ROBOT) return ", face: {robot: " + quotedYaml(face->robot) + "}";
  return ", face: " + (face->kind == FaceKind::POINT ? pointText(face->point) : toText(face->direction));
}

/// "text(first), text(second), ..."
template <typename List, typename Text>
std::string listText(const List& list, const Text& text) {
  std::string joined;
  for (const auto& element : list) joined += (joined.empty() ? "" : ", ") + text(element);
  return joined;
}

/// Writes the names and what they stand for under a key.
template <typename List, typename Text>
std::string section(const std::string& key, const List& list, const Text& text) {
  std::string joined;
  for (const auto& element : list) joined += "  " + quotedYaml(element.name) + ": {" + text(element) + "}\n";
  return joined.empty() ? "" : key + ":\n" + joined;
}

std::string sinkText(const WaypointDescription& waypoint, const PopulationDescription& population) {
  const bool is_nearest = waypoint.kind == Kind::NEAREST_SINK;
  return "sink: " + (is_nearest ? std::string(NEAREST_SINK) : quotedYaml(population.sinks[waypoint.target].name));
}

std::string waypointText(const WaypointDescription& waypoint, const PopulationDescription& population) {
  const auto alternative = [&](const WaypointDescription& other) { return waypointText(other, population); };
  switch (waypoint.kind) {
    case Kind::PLACE:
      return "{place: " + regionText(waypoint.place) + ", wait: " + rangeText(waypoint.wait) + faceText(waypoint.face) +
             "}";
    case Kind::QUEUE:
      return "{queue: " + quotedYaml(population.queues[waypoint.target].name) + "}";
    case Kind::SINK:
    case Kind::NEAREST_SINK:
      return "{" + sinkText(waypoint, population) + "}";
    case Kind::ONE_OF:
      break;
  }
  return "{one_of: [" + listText(waypoint.alternatives, alternative) + "]}";
}

std::string scheduleText(const SourceDescription& source) {
  std::string text = "times: [" + listText(source.times, [](double time) { return toText(time); }) + "]";
  if (source.rate) {
    text = "rate: " + toText(*source.rate) + (source.regular ? ", interval: regular" : "") +
           ", from: " + toText(source.from) + (std::isfinite(source.until) ? ", until: " + toText(source.until) : "");
  }
  const bool is_limited = source.count != std::numeric_limits<std::uint64_t>::max();
  return text + (is_limited ? ", count: " + std::to_string(source.count) : "");
}

std::string goalText(const AgentGroup& agents, const PopulationDescription& population) {
  if (agents.route) return "route: " + quotedYaml(population.routes[*agents.route].name);
  if (agents.opposite) return "goal: {opposite: " + pointText(*agents.opposite) + "}";
  return "goals: [" + listText(agents.goals, regionText) + "]";
}

std::string gateText(const GateDescription& gate) {
  const auto period = [](const Period& each) { return "[" + toText(each.begin) + ", " + toText(each.end) + "]"; };
  const std::string open = gate.open_in ? "[" + listText(*gate.open_in, period) + "]" : gate.open ? "true" : "false";
  return "wall: [" + pointText(gate.wall.from) + ", " + pointText(gate.wall.to) + "], open: " + open;
}

std::string sharesText(const GroupShare& groups) {
  if (groups.share <= 0.0) return "";
  const auto size = [](const GroupShare::Size& each) {
    return std::to_string(each.members) + ": " + toText(each.share);
  };
  return ", groups: {share: " + toText(groups.share) + ", sizes: {" + listText(groups.sizes, size) + "}}";
}

std::string sourcesText(const PopulationDescription& population) {
  std::string text;
  for (const SourceDescription& source : population.sources) {
    text += "  - {area: " + regionText(source.agents.position) + ", " + scheduleText(source) + ", " +
            goalText(source.agents, population) + kindText(source.agents, population) + reactionText(source.agents) +
            (source.agents.speed_of_kind ? "" : ", speed: " + rangeText(source.agents.max_speed)) +
            optionalText("hurry", source.agents.hurry, {1.0, 1.0}) +
            (source.agents.radius_of_kind ? "" : ", radius: " + rangeText(source.agents.radius)) +
            sharesText(source.agents.groups) + "}\n";
  }
  return text.empty() ? "" : "sources:\n" + text;
}

std::string attractionText(const AttractionDescription& attraction) {
  return "area: " + regionText(attraction.area) + ", radius: " + toText(attraction.radius) +
         ", share: " + toText(attraction.share) + ", wait: " + rangeText(attraction.wait) + faceText(attraction.face);
}

std::string alarmsText(const PopulationDescription& population) {
  std::string text;
  for (const AlarmDescription& alarm : population.alarms) {
    const std::string sink = alarm.route ? ", " + sinkText(alarm.route->waypoints.front(), population) : "";
    text += "  - {time: " + toText(alarm.time) + ", area: " + (alarm.area ? regionText(*alarm.area) : "all") + sink +
            ", speed_factor: " + toText(alarm.speed_factor) + optionalText("reaction_time", alarm.reaction_time) +
            (alarm.keeps_sources ? ", keep_sources: true" : "") + "}\n";
  }
  return text.empty() ? "" : "alarms:\n" + text;
}

}  // namespace

std::string rangeText(const Range& range) {
  return range.isFixed() ? toText(range.low) : "[" + toText(range.low) + ", " + toText(range.high) + "]";
}

std::string pointText(const Vector2& point) { return "[" + toText(point.x()) + ", " + toText(point.y()) + "]"; }

std::string pointsText(const std::vector<Vector2>& points) { return "[" + listText(points, pointText) + "]"; }

std::string headingText(double heading) {
  const double degrees = toDegrees(heading);
  const bool is_exact = wrapAngle(toRadians(degrees)) == heading;
  return is_exact ? toText(degrees) : "{radians: " + toText(heading) + "}";
}

std::string quotedYaml(const std::string& text) {
  std::string quoted = "'";
  for (const char letter : text) quoted += letter == '\'' ? "''" : std::string(1, letter);
  return quoted + "'";
}

std::string populationText(const PopulationDescription& population) {
  const auto route = [&](const RouteDescription& each) {
    const auto waypoint = [&](const WaypointDescription& other) { return waypointText(other, population); };
    return (each.repeat ? "repeat: true, " : "") + ("waypoints: [" + listText(each.waypoints, waypoint) + "]");
  };
  const auto sink = [](const SinkDescription& each) { return "area: " + regionText(each.area); };
  const auto queue = [](const QueueDescription& each) {
    return "head: " + pointText(each.head) + ", direction: " + toText(each.direction) +
           ", spacing: " + toText(each.spacing) + ", service: " + rangeText(each.service) + faceText(each.face);
  };
  return section("routes", population.routes, route) + sourcesText(population) +
         section("sinks", population.sinks, sink) + section("queues", population.queues, queue) +
         section("gates", population.gates, gateText) + section("attractions", population.attractions, attractionText) +
         alarmsText(population);
}

}  // namespace crowd
