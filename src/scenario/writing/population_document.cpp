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

std::string waypointText(const WaypointDescription& waypoint, const PopulationDescription& population) {
  const auto alternative = [&](const WaypointDescription& other) { return waypointText(other, population); };
  switch (waypoint.kind) {
    case Kind::PLACE:
      return "{place: " + regionText(waypoint.place) + ", wait: " + rangeText(waypoint.wait) + "}";
    case Kind::QUEUE:
      return "{queue: " + quotedYaml(population.queues[waypoint.target].name) + "}";
    case Kind::SINK:
      return "{sink: " + quotedYaml(population.sinks[waypoint.target].name) + "}";
    case Kind::NEAREST_SINK:
      return "{sink: nearest}";
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
  std::string sizes;
  for (std::size_t i = 0; i < groups.weights.size(); ++i) {
    sizes += (i > 0 ? ", " : "") + std::to_string(i + 2) + ": " + toText(groups.weights[i]);
  }
  return ", groups: {share: " + toText(groups.share) + ", sizes: {" + sizes + "}}";
}

std::string sourcesText(const PopulationDescription& population) {
  std::string text;
  for (const SourceDescription& source : population.sources) {
    text += "  - {area: " + regionText(source.agents.position) + ", " + scheduleText(source) + ", " +
            goalText(source.agents, population) + kindText(source.agents, population) +
            (source.agents.speed_of_kind ? "" : ", speed: " + rangeText(source.agents.max_speed)) +
            (source.agents.radius_of_kind ? "" : ", radius: " + rangeText(source.agents.radius)) +
            sharesText(source.agents.groups) + "}\n";
  }
  return text.empty() ? "" : "sources:\n" + text;
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
           ", spacing: " + toText(each.spacing) + ", service: " + rangeText(each.service);
  };
  return section("routes", population.routes, route) + sourcesText(population) +
         section("sinks", population.sinks, sink) + section("queues", population.queues, queue) +
         section("gates", population.gates, gateText);
}

}  // namespace crowd
