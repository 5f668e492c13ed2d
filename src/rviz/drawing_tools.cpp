#include "rviz/drawing_tools.h"

#include <social_crowd/AddGate.h>
#include <social_crowd/AddSource.h>
#include <social_crowd/AddWall.h>
#include <social_crowd/SpawnAgent.h>
#include <social_crowd/SpawnObstacle.h>
#include <social_crowd/SpawnRobot.h>

#include <cmath>
#include <pluginlib/class_list_macros.hpp>

#include "common/text/numbers.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

constexpr double LEAST_DRAG = 0.1;  // [m]; a shorter one is a click
constexpr float LEAST_RADIUS = 0.01F;
constexpr float MOST_RADIUS = 100.0F;
constexpr double GOAL_MARK = 0.2;    // [m]
constexpr double SOURCE_MARK = 1.6;  // of the second circle, in radii of the body

bool isClick(const Vector2& from, const Vector2& to) { return (to - from).norm() < LEAST_DRAG; }

rviz::FloatProperty* limited(rviz::FloatProperty* property, float least, float most) {
  property->setMin(least);
  property->setMax(most);
  return property;
}

rviz::FloatProperty* speedProperty(rviz::Property* parent, float speed = 1.3F) {
  return limited(new rviz::FloatProperty("Max speed", speed, "[m/s]", parent), 0.01F, 100.0F);
}

rviz::FloatProperty* bodyRadiusProperty(rviz::Property* parent, float radius = 0.25F) {
  return limited(new rviz::FloatProperty("Radius", radius, "Of the body [m]", parent), LEAST_RADIUS, MOST_RADIUS);
}

FloorOutline agentOutline(const Vector2& from, const Vector2& to, double radius) {
  FloorOutline lines = crossOutline(to, GOAL_MARK);
  lines.push_back(circleOutline(from, radius));
  lines.push_back({from, to});
  return lines;
}

}  // namespace

AddAgentTool::AddAgentTool()
    : FloorTool("Add agent",
                "<b>Press</b> where the agent is to stand, <b>release</b> at its goal. Right button: abandon"),
      max_speed_(speedProperty(getPropertyContainer())),
      radius_(bodyRadiusProperty(getPropertyContainer())) {}

FloorOutline AddAgentTool::outline(const Vector2& from, const Vector2& to) const {
  return agentOutline(from, to, radius_->getFloat());
}

void AddAgentTool::finish(const Vector2& from, const Vector2& to) {
  if (isClick(from, to)) return say("Add agent: drag from its place to its goal");
  const Vector2 way = to - from;
  social_crowd::SpawnAgent::Request request;
  request.pose.x = from.x();
  request.pose.y = from.y();
  request.pose.theta = std::atan2(way.y(), way.x());
  request.goal = toPoint(to);
  request.max_speed = max_speed_->getFloat();
  request.radius = radius_->getFloat();
  call<social_crowd::SpawnAgent>(names::SPAWN_AGENT, request);
}

AddRobotTool::AddRobotTool()
    : FloorTool("Add robot",
                "<b>Press</b> where the robot is to stand, <b>release</b> at its goal. Right button: abandon"),
      max_speed_(speedProperty(getPropertyContainer(), 1.0F)),
      radius_(bodyRadiusProperty(getPropertyContainer(), 0.3F)) {}

FloorOutline AddRobotTool::outline(const Vector2& from, const Vector2& to) const {
  return agentOutline(from, to, radius_->getFloat());
}

void AddRobotTool::finish(const Vector2& from, const Vector2& to) {
  const auto place = [](const Vector2& point) { return "[" + toText(point.x()) + ", " + toText(point.y()) + "]"; };
  social_crowd::SpawnRobot::Request request;
  request.robot = "{position: " + place(from) + ", radius: " + toText(double{radius_->getFloat()}) +
                  ", max_speed: " + toText(double{max_speed_->getFloat()}) +
                  (isClick(from, to) ? "" : ", goal: " + place(to)) + "}";
  call<social_crowd::SpawnRobot>(names::SPAWN_ROBOT, request);
}

AddObstacleTool::AddObstacleTool()
    : FloorTool("Add obstacle", "<b>Press</b> at the centre, <b>release</b> at the rim. Right button: abandon"),
      radius_(limited(new rviz::FloatProperty("Radius", 0.4F, "Of an obstacle that is added by a click [m]",
                                              getPropertyContainer()),
                      LEAST_RADIUS, MOST_RADIUS)) {}

double AddObstacleTool::radiusOf(const Vector2& from, const Vector2& to) const {
  return isClick(from, to) ? radius_->getFloat() : (to - from).norm();
}

FloorOutline AddObstacleTool::outline(const Vector2& from, const Vector2& to) const {
  return {circleOutline(from, radiusOf(from, to))};
}

void AddObstacleTool::finish(const Vector2& from, const Vector2& to) {
  social_crowd::SpawnObstacle::Request request;
  request.position = toPoint(from);
  request.radius = radiusOf(from, to);
  call<social_crowd::SpawnObstacle>(names::SPAWN_OBSTACLE, request);
}

DrawWallTool::DrawWallTool()
    : FloorTool("Draw wall",
                "<b>Press</b> at one end of the wall, <b>release</b> at the other. Right button: abandon") {}

FloorOutline DrawWallTool::outline(const Vector2& from, const Vector2& to) const { return {{from, to}}; }

void DrawWallTool::finish(const Vector2& from, const Vector2& to) {
  if (isClick(from, to)) return say("Draw wall: drag from one end of the wall to the other");
  social_crowd::AddWall::Request request;
  request.begin = toPoint(from);
  request.end = toPoint(to);
  call<social_crowd::AddWall>(names::ADD_WALL, request);
}

AddSourceTool::AddSourceTool()
    : FloorTool("Add source",
                "<b>Press</b> where agents are to appear, <b>release</b> at their goal. Right button: abandon"),
      rate_(limited(new rviz::FloatProperty("Rate", 0.5F, "Agents per second on average", getPropertyContainer()),
                    0.001F, 100.0F)),
      max_speed_(speedProperty(getPropertyContainer())),
      radius_(bodyRadiusProperty(getPropertyContainer())) {}

FloorOutline AddSourceTool::outline(const Vector2& from, const Vector2& to) const {
  FloorOutline lines = agentOutline(from, to, radius_->getFloat());
  lines.push_back(circleOutline(from, SOURCE_MARK * radius_->getFloat()));
  return lines;
}

void AddSourceTool::finish(const Vector2& from, const Vector2& to) {
  if (isClick(from, to)) return say("Add source: drag from its place to the goal of its agents");
  social_crowd::AddSource::Request request;
  request.position = toPoint(from);
  request.goal = toPoint(to);
  request.rate = rate_->getFloat();
  request.max_speed = max_speed_->getFloat();
  request.radius = radius_->getFloat();
  call<social_crowd::AddSource>(names::ADD_SOURCE, request);
}

AddGateTool::AddGateTool()
    : FloorTool("Add gate", "<b>Press</b> at one end of the gate, <b>release</b> at the other. Right button: abandon"),
      open_(new rviz::BoolProperty("Open", false, "Whether it is open at first", getPropertyContainer())) {}

FloorOutline AddGateTool::outline(const Vector2& from, const Vector2& to) const { return {{from, to}}; }

void AddGateTool::finish(const Vector2& from, const Vector2& to) {
  if (isClick(from, to)) return say("Add gate: drag from one end of the gate to the other");
  social_crowd::AddGate::Request request;
  request.begin = toPoint(from);
  request.end = toPoint(to);
  request.open = open_->getBool() ? 1 : 0;
  call<social_crowd::AddGate>(names::ADD_GATE, request);
}

}  // namespace crowd

PLUGINLIB_EXPORT_CLASS(crowd::AddAgentTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(crowd::AddGateTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(crowd::AddObstacleTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(crowd::AddRobotTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(crowd::AddSourceTool, rviz::Tool)
PLUGINLIB_EXPORT_CLASS(crowd::DrawWallTool, rviz::Tool)
