#include "scenario/writing/robot_document.h"

#include "common/text/numbers.h"
#include "scenario/writing/population_document.h"

namespace crowd {
namespace {

std::string entry(const std::string& key, const std::string& value) { return ", " + key + ": " + value; }

std::string number(const std::string& key, double value) { return entry(key, toText(value)); }

/// Degrees that a reader converts to the same angle, or nearly so.
std::string degreesText(double angle) { return toText(toDegrees(angle)); }

std::string limitsText(const RobotStart& robot) {
  const DriveLimits& limits = robot.limits;
  return entry("drive", DRIVES.nameOf(robot.drive)) + number("max_speed", limits.max_speed) +
         number("max_rotation", limits.max_rotation) + number("acceleration", limits.max_acceleration) +
         number("rotation_acceleration", limits.max_rotation_acceleration) +
         (robot.drive == Drive::ACKERMANN ? number("min_turning_radius", limits.min_turning_radius) : "") +
         (robot.reads_tf ? entry("pose_from", "tf") : "");
}

std::string scanText(const ScanSpec& scan) {
  return "{rays: " + std::to_string(scan.rays) +
         entry("angles", "[" + degreesText(scan.first_angle) + ", " + degreesText(scan.last_angle) + "]") +
         entry("range", "[" + toText(scan.min_range) + ", " + toText(scan.max_range) + "]") +
         entry("position", pointText(scan.mount.position)) + entry("heading", degreesText(scan.mount.heading)) +
         number("noise", scan.noise) + number("dropout", scan.dropout) + number("period", scan.period) +
         entry("people", SEEN_PEOPLE.nameOf(scan.people)) + entry("rings", std::to_string(scan.rings)) +
         entry("elevations", "[" + degreesText(scan.lowest_ring) + ", " + degreesText(scan.highest_ring) + "]") +
         number("height", scan.height) + "}";
}

std::string odometryText(const OdometrySpec& odometry) {
  return "{distance: " + toText(odometry.distance) + number("rotation", odometry.rotation) +
         number("heading_per_metre", odometry.heading_per_metre) + "}";
}

std::string tracksText(const TrackSpec& tracks) {
  return std::string("{occlusion: ") + (tracks.occlusion ? "true" : "false") +
         (tracks.range < INFINITE ? number("range", tracks.range) : "") + number("noise", tracks.noise) +
         number("velocity_noise", tracks.velocity_noise) + number("missed", tracks.missed) +
         number("false_detections", tracks.false_detections) + (tracks.keep ? number("keep", *tracks.keep) : "") + "}";
}

std::string entryOf(const RobotStart& robot) {
  const Footprint& footprint = robot.footprint;
  return "  - {name: " + quotedYaml(robot.name) + entry("namespace", quotedYaml(robot.name_space)) +
         entry("position", pointText(robot.position)) + entry("heading", headingText(robot.heading)) +
         (robot.goals.empty() ? "" : entry("goals", pointsText(robot.goals))) +
         (footprint.isDisc() ? number("radius", footprint.radius) : entry("footprint", pointsText(footprint.corners))) +
         limitsText(robot) + number("cmd_timeout", robot.cmd_timeout) + number("goal_tolerance", robot.goal_tolerance) +
         entry("perceived", robot.perceived ? "true" : "false") + entry("yields", YIELDS.nameOf(robot.yields)) +
         number("comfort", robot.comfort) + entry("odometry", odometryText(robot.odometry)) +
         entry("scan", scanText(robot.scan)) + entry("tracks", tracksText(robot.tracks)) + "}\n";
}

}  // namespace

std::string robotsText(const Scene& scene) {
  std::string text;
  for (const RobotStart& robot : scene.robots) text += entryOf(robot);
  if (!text.empty()) text = "robots:\n" + text;
  return text + (scene.ends == Ends::ALL ? "" : "ends: " + ENDS.nameOf(scene.ends) + "\n");
}

}  // namespace crowd
