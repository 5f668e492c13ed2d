#include "scenario/population_checks.h"

#include <algorithm>
#include <optional>
#include <string>

#include "common/text/numbers.h"
#include "geometry/impact.h"
#include "geometry/limits.h"
#include "geometry/wall_index.h"
#include "maps/occupancy_map.h"
#include "scenario/population_spec.h"
#include "scenario/region_geometry.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

using Kind = WaypointDescription::Kind;

constexpr int TRIES = 1000;               // draws of a place in a region
constexpr double REGION_GRID_STEP = 0.1;  // [m], if none of them fits

class PopulationCheck {
 public:
  explicit PopulationCheck(const Scenario& scenario)
      : scenario_(scenario), population_(*scenario.population), walls_(allWalls(scenario)) {
    if (scenario.map) frame_.emplace(*scenario.map);
    for (const AgentGroup& group : scenario.agents) include(group);
    for (const SourceDescription& source : population_.sources) include(source.agents);
  }

  void run() const;

 private:
  void include(const AgentGroup& group) {
    largest_ = std::max(largest_, group.radius.high);
    fastest_ = std::max(fastest_, group.max_speed.high);
  }
  static std::vector<Segment> allWalls(const Scenario& scenario) {
    std::vector<Segment> walls = scenario.walls;
    if (scenario.map_walls) walls.insert(walls.end(), scenario.map_walls->begin(), scenario.map_walls->end());
    return walls;
  }
  bool fits(const Vector2& place, double radius) const;
  bool hasRoom(const Region& region, double radius) const;
  /// @param field name of the region, such as sources[0].area
  void require(const Region& region, double radius, int line, const std::string& field) const;
  void requireWaypoint(const WaypointDescription& waypoint, double radius, const std::string& field) const;
  void requireSpeed(std::size_t number) const;
  /// The robot that agents are to look at must be there.
  void requireRobot(const std::optional<FacingDescription>& face, int line, const std::string& field) const;
  /// The radius of the largest agent that begins on a route; that of all agents if there is none.
  double radiusOnRoute(std::size_t route) const;

  const Scenario& scenario_;
  const PopulationDescription& population_;
  WallIndex walls_;
  std::optional<CellFrame> frame_;  // of the map, if there is one
  double largest_ = 0.0;            // radius of all agents [m]
  double fastest_ = 0.0;            // speed of all agents [m/s]
};

bool PopulationCheck::fits(const Vector2& place, double radius) const {
  if (walls_.isAnyWithin(place, radius - TOUCH_TOLERANCE)) return false;
  return !frame_ || scenario_.map->isFree(frame_->cellAt(place));
}

bool PopulationCheck::hasRoom(const Region& region, double radius) const {
  if (region.kind == Region::Kind::FREE) return true;  // the reader of the map has checked that
  if (region.isFixed()) return fits(region.first, radius);
  KeyedRandom random(0, KeyedRandom::PLACEMENT, {});
  for (int tries = 0; tries < TRIES; ++tries) {
    if (fits(region.draw(random), radius)) return true;
  }
  const std::vector<Vector2> grid = gridPoints(region, REGION_GRID_STEP);
  return std::any_of(grid.begin(), grid.end(), [&](const Vector2& point) { return fits(point, radius); });
}

void PopulationCheck::require(const Region& region, double radius, int line, const std::string& field) const {
  if (hasRoom(region, radius)) return;
  throw InputError(scenario_.source + ", line " + std::to_string(line) + ": " + field +
                   ": expected a place where an agent of radius " + toText(radius) + " m fits, got " +
                   (region.isFixed() ? "one in a wall or nearer to one" : "only such in walls or nearer to one"));
}

void PopulationCheck::requireWaypoint(const WaypointDescription& waypoint, double radius,
                                      const std::string& field) const {
  if (waypoint.kind == Kind::PLACE) require(waypoint.place, radius, waypoint.line, field + ".place");
  requireRobot(waypoint.face, waypoint.line, field);
  for (std::size_t i = 0; i < waypoint.alternatives.size(); ++i) {
    requireWaypoint(waypoint.alternatives[i], radius, field + ".one_of[" + std::to_string(i) + "]");
  }
}

void PopulationCheck::requireRobot(const std::optional<FacingDescription>& face, int line,
                                   const std::string& field) const {
  if (!face || face->kind != FacingDescription::Kind::ROBOT) return;
  std::vector<std::string> names;
  for (const RobotGroup& robot : scenario_.robots) names.push_back(robot.start.name);
  if (std::find(names.begin(), names.end(), face->robot) != names.end()) return;
  throw InputError(scenario_.source + ", line " + std::to_string(line) + ": " + field +
                   ".face.robot: " + unknownNameText("robot", face->robot, names));
}

double PopulationCheck::radiusOnRoute(std::size_t route) const {
  double radius = 0.0;
  const auto include = [&](const AgentGroup& group) {
    if (group.route == route) radius = std::max(radius, group.radius.high);
  };
  for (const AgentGroup& group : scenario_.agents) include(group);
  for (const SourceDescription& source : population_.sources) include(source.agents);
  return radius > 0.0 ? radius : largest_;
}

/// Nobody may be faster than the greatest permitted speed.
void PopulationCheck::requireSpeed(std::size_t number) const {
  const AlarmDescription& alarm = population_.alarms[number];
  if (fastest_ * alarm.speed_factor <= limits::SPEED.most) return;
  throw InputError(scenario_.source + ", line " + std::to_string(alarm.line) + ": alarms[" + std::to_string(number) +
                   "].speed_factor: expected one with which agents walk at most " + toText(limits::SPEED.most) +
                   " m/s, got " + toText(alarm.speed_factor));
}

void PopulationCheck::run() const {
  for (std::size_t i = 0; i < population_.alarms.size(); ++i) requireSpeed(i);
  for (std::size_t i = 0; i < population_.sources.size(); ++i) {
    const AgentGroup& group = population_.sources[i].agents;
    const std::string field = "sources[" + std::to_string(i) + "]";
    require(group.position, group.radius.high, group.line, field + ".area");
    for (const Region& goal : group.goals) require(goal, group.radius.high, group.line, field + ".goal");
  }
  for (std::size_t route = 0; route < population_.routes.size(); ++route) {
    const RouteDescription& description = population_.routes[route];
    for (std::size_t i = 0; i < description.waypoints.size(); ++i) {
      requireWaypoint(description.waypoints[i], radiusOnRoute(route),
                      "routes." + description.name + ".waypoints[" + std::to_string(i) + "]");
    }
  }
  for (const SinkDescription& sink : population_.sinks) {
    require(sink.area, largest_, sink.line, "sinks." + sink.name + ".area");
  }
  for (const QueueDescription& queue : population_.queues) {
    Region head;
    head.first = queue.head;
    require(head, largest_, queue.line, "queues." + queue.name + ".head");
    requireRobot(queue.face, queue.line, "queues." + queue.name);
  }
  for (const AttractionDescription& attraction : population_.attractions) {
    require(attraction.area, largest_, attraction.line, "attractions." + attraction.name + ".area");
    requireRobot(attraction.face, attraction.line, "attractions." + attraction.name);
  }
}

}  // namespace

void checkPopulation(const Scenario& scenario) { PopulationCheck(scenario).run(); }

}  // namespace crowd
