#include "ros/markers/marker_drawings.h"

#include <algorithm>
#include <cmath>

#include "geometry/footprint.h"
#include "ros/messages/agent_status.h"
#include "ros/messages/conversions.h"

namespace crowd {
namespace {

using marker_style::Layer;
using social_crowd::AgentState;
using social_crowd::AgentStates;
using social_crowd::RobotState;
using social_crowd::RobotStates;
using visualization_msgs::Marker;

/// RViz uses single precision; larger coordinates are taken as invalid [m].
constexpr double FARTHEST = 1e6;

bool isDrawable(double number) { return std::abs(number) <= FARTHEST; }  // false for NaN
bool isDrawable(const geometry_msgs::Point& point) { return isDrawable(point.x) && isDrawable(point.y); }

Pose poseOf(const AgentState& agent) { return {{agent.pose.x, agent.pose.y}, agent.pose.theta}; }

std::vector<Vector2> circleFor(std::size_t bodies) { return unitCircle(marker_style::cornersFor(bodies)); }

Pose poseOf(const RobotState& robot) { return {{robot.pose.x, robot.pose.y}, robot.pose.theta}; }

/// Corners that cannot be drawn are left out.
Footprint footprintOf(const RobotState& robot) {
  Footprint footprint;
  for (const geometry_msgs::Point& corner : robot.footprint) {
    if (isDrawable(corner)) footprint.corners.push_back(fromPoint(corner));
  }
  if (isDrawable(robot.radius)) footprint.radius = robot.radius;
  return footprint;
}

std::vector<Vector2> outlineOf(const RobotState& robot) {
  Footprint footprint = footprintOf(robot);
  if (footprint.isDisc()) footprint.corners = unitCircle(marker_style::MAX_CORNERS);
  const double scale = robot.footprint.empty() ? footprint.radius : 1.0;
  for (Vector2& corner : footprint.corners) corner *= scale;
  return footprint.cornersAt(poseOf(robot));
}

/// Number of the first marker of paths in their namespace.
int firstPathOf(Walkers walkers) { return walkers == Walkers::AGENTS ? 0 : 2; }

marker_style::Colour pathColour(Walkers walkers, std::uint32_t body) {
  return marker_style::paler(walkers == Walkers::AGENTS ? marker_style::ofAgent(body) : marker_style::ofRobot());
}

void addPiece(LineMarker& marker, const WalkedPaths& paths, const WalkedPaths::Point& from,
              const WalkedPaths::Point& to, const marker_style::Colour& colour) {
  const double begin = paths.strengthAt(from.time);
  const double end = paths.strengthAt(to.time);
  if (end <= 0.0) return;
  marker.addLine(from.position, to.position, marker_style::faded(colour, begin), marker_style::faded(colour, end));
}

}  // namespace

bool hasPlace(const AgentState& agent) { return isDrawable(agent.pose.x) && isDrawable(agent.pose.y); }

bool isOnFloor(const AgentState& agent) {
  return isPresent(agent) && hasPlace(agent) && isDrawable(agent.pose.theta) && isDrawable(agent.radius);
}

Marker drawBodies(const AgentStates& states, bool figures) {
  TriangleMarker marker(marker_style::BODIES, 0, Layer::BODIES);
  const std::vector<Vector2> circle = circleFor(states.agents.size());
  for (const AgentState& agent : states.agents) {
    if (!isOnFloor(agent)) continue;
    const auto colour = figures ? marker_style::underFigure(agent.agent) : marker_style::ofAgent(agent.agent);
    marker.addDisc(poseOf(agent).position, agent.radius, circle, colour);
  }
  return marker.finish();
}

Marker drawContacts(const AgentStates& states) {
  TriangleMarker marker(marker_style::BODIES, 1, Layer::CONTACTS);
  const std::vector<Vector2> circle = circleFor(states.agents.size());
  for (const AgentState& agent : states.agents) {
    if (!isOnFloor(agent) || agent.in_contact == 0) continue;
    const double outer = agent.radius + 0.5 * marker_style::CONTACT_WIDTH;
    marker.addRing(poseOf(agent).position, outer - marker_style::CONTACT_WIDTH, outer, circle,
                   marker_style::ofContact());
  }
  return marker.finish();
}

Marker drawRecordedBodies(const AgentStates& people, bool figures) {
  TriangleMarker marker(marker_style::RECORDED, 1, Layer::BODIES);
  const std::vector<Vector2> circle = circleFor(people.agents.size());
  const marker_style::Colour colour =
      figures ? marker_style::paler(marker_style::ofRecorded()) : marker_style::ofRecorded();
  for (const AgentState& person : people.agents) {
    if (isOnFloor(person)) marker.addDisc(poseOf(person).position, person.radius, circle, colour);
  }
  return marker.finish();
}

Marker drawHeadings(const AgentStates& states, bool figures, const char* marker_namespace) {
  TriangleMarker marker(marker_namespace, 0, Layer::HEADINGS);
  for (const AgentState& agent : states.agents) {
    if (!figures && isOnFloor(agent)) marker.addArrow(poseOf(agent), agent.radius, marker_style::ofHeading());
  }
  return marker.finish();
}

Marker drawGoals(const AgentStates& states) {
  LineMarker marker(marker_style::GOALS, 0, Layer::GOALS, marker_style::GOAL_WIDTH);
  for (const AgentState& agent : states.agents) {
    if (agent.status == AgentState::REMOVED || !isDrawable(agent.goal)) continue;
    marker.addCross(fromPoint(agent.goal), marker_style::GOAL_SIZE, marker_style::ofAgent(agent.agent));
  }
  return marker.finish();
}

Marker drawObstacles(const AgentStates& states) {
  TriangleMarker marker(marker_style::OBSTACLES, 0, Layer::OBSTACLES);
  const std::vector<Vector2> circle = circleFor(states.obstacles.size());
  for (const social_crowd::ObstacleState& obstacle : states.obstacles) {
    if (obstacle.recorded != 0 || !isDrawable(obstacle.position) || !isDrawable(obstacle.radius)) continue;
    marker.addDisc(fromPoint(obstacle.position), obstacle.radius, circle, marker_style::ofObstacle());
  }
  return marker.finish();
}

Marker drawWalls(const std::vector<social_crowd::Wall>& walls) {
  LineMarker marker(marker_style::WALLS, 0, Layer::WALLS, marker_style::WALL_WIDTH);
  for (const social_crowd::Wall& wall : walls) {
    if (!isDrawable(wall.from) || !isDrawable(wall.to)) continue;
    marker.addLine(fromPoint(wall.from), fromPoint(wall.to), marker_style::ofWall());
  }
  return marker.finish();
}

bool hasPlace(const RobotState& robot) {
  return isDrawable(robot.pose.x) && isDrawable(robot.pose.y) && isDrawable(robot.pose.theta);
}

Marker drawRobots(const RobotStates& states) {
  TriangleMarker marker(marker_style::ROBOTS, 0, Layer::BODIES);
  for (const RobotState& robot : states.robots) {
    if (hasPlace(robot)) marker.addPolygon(outlineOf(robot), marker_style::ofRobot());
  }
  return marker.finish();
}

Marker drawRobotHeadings(const RobotStates& states) {
  TriangleMarker marker(marker_style::ROBOTS, 1, Layer::HEADINGS);
  for (const RobotState& robot : states.robots) {
    if (!hasPlace(robot)) continue;
    const double inner = -distance(footprintOf(robot), Pose(), Vector2::Zero());  // radius of a disc within it
    if (inner > 0.0) marker.addArrow(poseOf(robot), inner, marker_style::ofHeading());
  }
  return marker.finish();
}

Marker drawRobotContacts(const RobotStates& states) {
  LineMarker marker(marker_style::ROBOTS, 2, Layer::CONTACTS, marker_style::CONTACT_WIDTH);
  for (const RobotState& robot : states.robots) {
    if (hasPlace(robot) && !robot.contacts.empty()) marker.addPolygon(outlineOf(robot), marker_style::ofContact());
  }
  return marker.finish();
}

Marker drawRobotGoals(const RobotStates& states) {
  LineMarker marker(marker_style::GOALS, 1, Layer::GOALS, marker_style::GOAL_WIDTH);
  for (const RobotState& robot : states.robots) {
    if (robot.has_goal == 0 || !isDrawable(robot.goal)) continue;
    marker.addCross(fromPoint(robot.goal), marker_style::ROBOT_GOAL_SIZE, marker_style::ofRobot());
  }
  return marker.finish();
}

Marker drawSettledPaths(const WalkedPaths& paths, Walkers walkers) {
  LineMarker marker(marker_style::PATHS, firstPathOf(walkers), Layer::PATHS, marker_style::PATH_WIDTH);
  for (const auto& [body, path] : paths.paths()) {
    const auto colour = pathColour(walkers, body);
    for (std::size_t i = 1; i < path.settled; ++i) addPiece(marker, paths, path.points[i - 1], path.points[i], colour);
  }
  return marker.finish();
}

Marker drawRecentPaths(const WalkedPaths& paths, Walkers walkers) {
  LineMarker marker(marker_style::PATHS, firstPathOf(walkers) + 1, Layer::PATHS, marker_style::PATH_WIDTH);
  for (const auto& [body, path] : paths.paths()) {
    const auto colour = pathColour(walkers, body);
    for (std::size_t i = std::max<std::size_t>(path.settled, 1); i < path.points.size(); ++i) {
      addPiece(marker, paths, path.points[i - 1], path.points[i], colour);
    }
    if (path.tip != path.points.back().position) {
      addPiece(marker, paths, path.points.back(), {path.tip, path.tip_time}, colour);
    }
  }
  return marker.finish();
}

RadiiDrawing::RadiiDrawing(std::size_t agents)
    : marker_(marker_style::RADII, 0, Layer::RADII, marker_style::RADIUS_WIDTH),
      circle_(unitCircle(2 * marker_style::cornersFor(agents))) {}

void RadiiDrawing::add(const AgentState& agent, const std::vector<double>& limits, bool faint) {
  if (!isOnFloor(agent)) return;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (!isDrawable(limits[i])) continue;
    const auto colour = marker_style::ofRadius(i + 1, limits.size());
    marker_.addCircle(poseOf(agent).position, limits[i], circle_, faint ? marker_style::paler(colour) : colour);
  }
}

Marker drawSectors(const Pose& pose, const std::vector<OccupiedSector>& sectors, const std::vector<double>& limits) {
  TriangleMarker marker(marker_style::SECTORS, 0, Layer::SECTORS);
  const bool fine = isDrawable(pose.position.x()) && isDrawable(pose.position.y()) && isDrawable(pose.heading);
  for (const OccupiedSector& sector : sectors) {
    const auto index =
        static_cast<std::size_t>(sector.distance_class) - 1;  // class 0 (none) wraps to the largest number
    if (!fine || index >= limits.size() || !isDrawable(limits[index])) continue;
    const double inner = index == 0 ? 0.0 : limits[index - 1];
    marker.addRingPart(pose.position, inner, limits[index], pose.heading + sector.from, pose.heading + sector.to,
                       marker_style::ofSector(index + 1, limits.size()));
  }
  return marker.finish();
}

}  // namespace crowd
