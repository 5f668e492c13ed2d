#include "scenario/reading/robot_reader.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <string>

#include "common/text/quotes.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

enum class PoseSource : std::uint8_t { ODOM = 0, TF = 1 };
constexpr EnumNames<PoseSource, 2> POSE_SOURCES{"pose_from", {"odom", "tf"}};

bool isName(const std::string& text) {
  const auto is_part = [](unsigned char letter) { return std::isalnum(letter) != 0 || letter == '_'; };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) != 0 &&
         std::all_of(text.begin(), text.end(), is_part);
}

void readDrive(const YamlMap& map, const Units& units, RobotStart& start) {
  start.drive = DRIVES.read(map, Drive::DIFFERENTIAL);
  DriveLimits& limits = start.limits;
  limits.max_speed = units.speed(map.number("max_speed", units.limit(limits::SPEED)));
  limits.max_rotation = map.number("max_rotation", limits::ROTATION, limits.max_rotation);
  limits.max_acceleration = map.number("acceleration", limits::ACCELERATION, limits.max_acceleration);
  limits.max_rotation_acceleration =
      map.number("rotation_acceleration", limits::ROTATION_ACCELERATION, limits.max_rotation_acceleration);
  const YAML::Node turning = map.find("min_turning_radius");
  if (start.drive == Drive::ACKERMANN) {
    limits.min_turning_radius = map.number("min_turning_radius", limits::DISTANCE);
  } else if (turning) {
    throwProblem(map.placeOf("min_turning_radius"), turning, "is for drive: ackermann only");
  }
  start.reads_tf = POSE_SOURCES.read(map, PoseSource::ODOM) == PoseSource::TF;
  if (start.drive != Drive::EXTERNAL && map.has("pose_from")) {
    throwProblem(map.placeOf("pose_from"), map.need("pose_from"), "is for drive: external only");
  }
}

void readCourtesy(const YamlMap& map, RobotStart& start) {
  start.perceived = map.flag("perceived", true);
  start.comfort = map.number("comfort", limits::DISTANCE_OR_0, DEFAULT_COMFORT);
  start.yields = YIELDS.read(map, start.perceived ? Yields::CROWD : Yields::NOBODY);
  if (start.perceived || !doesCrowdYield(start.yields)) return;
  throwProblem(map.placeOf("yields"), map.need("yields"),
               "'" + YIELDS.nameOf(start.yields) + "' needs perceived: true");
}

void readOdometry(const YamlMap& parent, OdometrySpec& odometry) {
  const YAML::Node node = parent.find("odometry");
  if (!node) return;
  const YamlMap map(node, parent.placeOf("odometry"), {"distance", "rotation", "heading_per_metre"});
  odometry.distance = map.number("distance", limits::ODOMETRY_ERROR, 0.0);
  odometry.rotation = map.number("rotation", limits::ODOMETRY_ERROR, 0.0);
  odometry.heading_per_metre = map.number("heading_per_metre", limits::ODOMETRY_ERROR, 0.0);
}

/// Reads [low, high], the lower number first.
Range readPair(const YamlMap& map, const std::string& key, const NumberLimit& limit, const Range& otherwise) {
  const YAML::Node node = map.find(key);
  if (!node) return otherwise;
  const YamlPlace place = map.placeOf(key);
  const Range range = node.IsSequence() ? readRange(node, place, limit) : Range();
  if (range.isFixed()) throwExpected(place, node, "[low, high]");
  return range;
}

void readScan(const YamlMap& parent, ScanSpec& scan) {
  const YAML::Node node = parent.find("scan");
  if (!node) return;
  const YamlMap map(node, parent.placeOf("scan"),
                    {"rays", "angles", "range", "position", "heading", "noise", "dropout", "period", "people", "rings",
                     "elevations", "height"});
  scan.rays = static_cast<std::uint32_t>(map.whole("rays", 1, limits::RAYS, scan.rays));
  const Range angles = readPair(map, "angles", NumberRule::ANY, {-180.0, 180.0});
  if (angles.high - angles.low > 360.0) throwExpected(map.placeOf("angles"), map.need("angles"), "at most 360 degrees");
  scan.first_angle = toRadians(angles.low);
  scan.last_angle = toRadians(angles.high);
  const Range range = readPair(map, "range", limits::DISTANCE_OR_0, {scan.min_range, scan.max_range});
  scan.min_range = range.low;
  scan.max_range = range.high;
  if (const YAML::Node position = map.find("position")) {
    scan.mount.position = readVector(position, map.placeOf("position"), limits::OFFSET);
  }
  scan.mount.heading = toRadians(map.number("heading", NumberRule::ANY, 0.0));
  scan.noise = map.number("noise", limits::DISTANCE_OR_0, scan.noise);
  scan.dropout = map.number("dropout", NumberRule::FRACTION, scan.dropout);
  scan.period = map.number("period", NumberRule::NOT_NEGATIVE, scan.period);
  scan.people = SEEN_PEOPLE.read(map, scan.people);
  scan.rings = static_cast<std::uint32_t>(map.whole("rings", 0, limits::RINGS, scan.rings));
  const NumberLimit elevation{NumberRule::ANY, 89.0, "degrees"};
  const Range elevations = readPair(map, "elevations", elevation, {-15.0, 15.0});
  scan.lowest_ring = toRadians(elevations.low);
  scan.highest_ring = toRadians(elevations.high);
  scan.height = map.number("height", limits::DISTANCE_OR_0, scan.height);
  if (scan.rings > 0 && scan.height <= 0.0) throwProblem(map.place(), node, "rings need a height above 0 m");
}

void readTracks(const YamlMap& parent, TrackSpec& tracks) {
  const YAML::Node node = parent.find("tracks");
  if (!node) return;
  const YamlMap map(node, parent.placeOf("tracks"),
                    {"occlusion", "range", "noise", "velocity_noise", "missed", "false_detections", "keep"});
  tracks.occlusion = map.flag("occlusion", tracks.occlusion);
  tracks.range = map.number("range", limits::DISTANCE, tracks.range);
  tracks.noise = map.number("noise", limits::DISTANCE_OR_0, tracks.noise);
  tracks.velocity_noise = map.number("velocity_noise", limits::SPEED_OR_0, tracks.velocity_noise);
  tracks.missed = map.number("missed", NumberRule::FRACTION, tracks.missed);
  tracks.false_detections = map.number("false_detections", limits::FALSE_DETECTIONS, tracks.false_detections);
  if (map.has("keep")) tracks.keep = map.number("keep", limits::KEEP);
}

/// The places of a route that a robot can follow.
std::vector<Region> placesOf(const YamlMap& map, const PopulationDescription& population) {
  const RouteDescription& route = population.routes[readNameOf(population.routes, map, "route")];
  std::vector<Region> places;
  for (const WaypointDescription& waypoint : route.waypoints) {
    const bool is_place = waypoint.kind == WaypointDescription::Kind::PLACE && waypoint.wait.high <= 0.0;
    if (!is_place || route.repeat) {
      throwProblem(map.placeOf("route"), map.need("route"),
                   "a robot follows a route of places alone, without wait and repeat");
    }
    places.push_back(waypoint.place);
  }
  return places;
}

void readGoals(const YamlMap& map, const PopulationDescription& population, RobotGroup& group) {
  const int kinds = (map.has("goal") ? 1 : 0) + (map.has("goals") ? 1 : 0) + (map.has("route") ? 1 : 0);
  if (kinds > 1) throwProblem(map.place(), map.node(), "expected only one of goal, goals and route");
  if (map.has("goal")) group.goals = {readRegion(map.need("goal"), map.placeOf("goal"))};
  if (map.has("goals")) group.goals = readRegions(map.need("goals"), map.placeOf("goals"));
  if (map.has("route")) group.goals = placesOf(map, population);
}

RobotGroup readRobot(const YAML::Node& node, const YamlPlace& place, const Units& units, double goal_tolerance,
                     const PopulationDescription& population) {
  const YamlMap map(node, place,
                    {"name",
                     "namespace",
                     "position",
                     "heading",
                     "goal",
                     "goals",
                     "route",
                     "radius",
                     "footprint",
                     "drive",
                     "max_speed",
                     "max_rotation",
                     "acceleration",
                     "rotation_acceleration",
                     "min_turning_radius",
                     "cmd_timeout",
                     "goal_tolerance",
                     "perceived",
                     "yields",
                     "comfort",
                     "odometry",
                     "scan",
                     "tracks",
                     "pose_from"});
  RobotGroup group;
  group.line = lineOf(node);
  RobotStart& start = group.start;
  start.name = readRobotName(map, "name");
  const bool has_own_names = map.has("namespace") && !map.text("namespace").empty();
  start.name_space = has_own_names ? readRobotName(map, "namespace") : "";
  group.position = readRegion(map.need("position"), map.placeOf("position"));
  if (const YAML::Node heading = map.find("heading")) group.heading = readHeading(heading, map.placeOf("heading"));
  readGoals(map, population, group);
  readFootprint(map, start.footprint);
  readDrive(map, units, start);
  start.cmd_timeout = map.number("cmd_timeout", NumberRule::POSITIVE, DEFAULT_COMMAND_TIMEOUT);
  start.goal_tolerance = map.number("goal_tolerance", limits::DISTANCE, goal_tolerance);
  readCourtesy(map, start);
  readOdometry(map, start.odometry);
  readScan(map, start.scan);
  readTracks(map, start.tracks);
  return group;
}

}  // namespace

std::string readRobotName(const YamlMap& map, const std::string& key) {
  std::string name = map.text(key);
  if (!isName(name)) throwExpected(map.placeOf(key), map.need(key), "letters, digits and _, with a letter first");
  return name;
}

void readFootprint(const YamlMap& map, Footprint& footprint) {
  const YAML::Node corners = map.find("footprint");
  if (corners && map.has("radius")) {
    throwProblem(map.placeOf("footprint"), corners, "expected either radius or footprint, got both");
  }
  if (!corners) {
    footprint.radius = map.number("radius", limits::RADIUS);
    return;
  }
  footprint.corners = readList<Vector2>(
      corners, map.placeOf("footprint"),
      [](const YAML::Node& corner, const YamlPlace& at) { return readVector(corner, at, limits::OFFSET); });
  const std::string problem = problemOf(footprint.corners);
  if (!problem.empty()) throwProblem(map.placeOf("footprint"), corners, problem);
}

std::vector<RobotGroup> readRobots(const YamlMap& map, const Units& units, double goal_tolerance,
                                   const PopulationDescription& population) {
  const YAML::Node list = map.find("robots");
  const YamlPlace place = map.placeOf("robots");
  const auto read = [&](const YAML::Node& node, const YamlPlace& at) {
    return readRobot(node, at, units, goal_tolerance, population);
  };
  std::vector<RobotGroup> robots = readList<RobotGroup>(list, place, read);
  if (robots.size() > limits::ROBOTS) {
    throwExpected(place, list, "at most " + std::to_string(limits::ROBOTS) + " robots");
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    RobotStart& start = robots[i].start;
    for (std::size_t k = 0; k < i; ++k) {
      if (robots[k].start.name != start.name) continue;
      throwProblem(place.element(i).child("name"), list[i], "there are two robots " + inQuotes(start.name));
    }
    if (robots.size() > 1 && !list[i]["namespace"]) start.name_space = start.name;
    for (std::size_t k = 0; k < i; ++k) {
      if (robots[k].start.name_space != start.name_space) continue;
      throwProblem(place.element(i).child("namespace"), list[i],
                   "there are two robots in the namespace " + inQuotes(start.name_space));
    }
  }
  return robots;
}

RobotStart readRobotStart(const std::string& entry, double goal_tolerance, bool is_only,
                          const std::string& other_name) {
  YAML::Node node;
  try {
    node = YAML::Load(entry);
  } catch (const YAML::Exception& error) {
    throw InputError(std::string("robot: ") + error.what());
  }
  if (node.IsMap() && !node["name"] && !other_name.empty()) node["name"] = other_name;
  const YamlPlace place = YamlPlace().child("robot");
  const RobotGroup group = readRobot(node, place, Units(), goal_tolerance, PopulationDescription());
  const bool is_fixed = group.position.isFixed() && (!group.heading || group.heading->isFixed()) &&
                        std::all_of(group.goals.begin(), group.goals.end(), std::mem_fn(&Region::isFixed));
  if (!is_fixed) throwProblem(place, node, "expected a fixed position, heading and goals");
  RobotStart start = group.start;
  start.position = group.position.first;
  for (const Region& goal : group.goals) start.goals.push_back(goal.first);
  if (group.heading) {
    start.heading = wrapAngle(group.heading->low);
  } else if (!start.goals.empty()) {
    start.heading = bearingOf(start.goals.front() - start.position);
  }
  if (!is_only && !node["namespace"]) start.name_space = start.name;
  return start;
}

}  // namespace crowd
