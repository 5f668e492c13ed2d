// Handlers of the services that change the world.

#include "ros/controller/world_services.h"

#include "common/text/quotes.h"
#include "ros/messages/conversions.h"

namespace crowd {
namespace {

Region pointRegion(const geometry_msgs::Point& point) {
  Region region;
  region.first = fromPoint(point);
  return region;
}

SourceDescription sourceOf(const social_crowd::AddSource::Request& request, const Episode& episode) {
  SourceDescription source;
  source.agents.position = pointRegion(request.position);
  source.agents.max_speed = {request.max_speed, request.max_speed};
  source.agents.radius = {request.radius, request.radius};
  source.rate = request.rate;
  if (request.count > 0) source.count = request.count;
  if (request.route.empty()) {
    source.agents.goals = {pointRegion(request.goal)};
  } else {
    const auto& population = episode.scene().population;
    const std::vector<RouteDescription> routes = population ? population->routes : std::vector<RouteDescription>();
    source.agents.route = findName(routes, request.route);
    if (!source.agents.route) throw InputError(unknownNameText("route", request.route, namesOf(routes)));
  }
  return source;
}

AlarmDescription alarmOf(const social_crowd::Alarm::Request& request, const Episode& episode) {
  AlarmDescription alarm;
  if (!request.all) {
    Region& box = alarm.area.emplace();
    box.kind = Region::Kind::BOX;
    box.first = fromPoint(request.lower);
    box.second = fromPoint(request.upper);
  }
  if (!request.sink.empty()) {
    const auto& population = episode.scene().population;
    alarm.route =
        alarmRoute(sinkWaypoint(request.sink, population ? population->sinks : std::vector<SinkDescription>()));
  }
  alarm.speed_factor = request.speed_factor;
  alarm.keeps_sources = request.keep_sources != 0;
  return alarm;
}

std::string newGateName(const Episode& episode) {
  const auto& population = episode.scene().population;
  for (std::size_t i = 0;; ++i) {
    std::string name = "gate_" + std::to_string(i);
    if (!population || !findName(population->gates, name)) return name;
  }
}

GateDescription gateOf(const social_crowd::AddGate::Request& request) {
  constexpr std::size_t MOST_PERIODS = 1000;
  requireFew("open_from", request.open_from.size(), MOST_PERIODS);
  GateDescription gate;
  gate.name = request.gate;
  gate.wall = {fromPoint(request.begin), fromPoint(request.end)};
  gate.open = request.open != 0;
  if (request.open_from.size() != request.open_until.size()) {
    throw InputError("open_until: expected as many times as in open_from, " + std::to_string(request.open_from.size()) +
                     ", got " + std::to_string(request.open_until.size()));
  }
  if (request.open_from.empty()) return gate;
  gate.open_in.emplace();
  for (std::size_t i = 0; i < request.open_from.size(); ++i) {
    gate.open_in->push_back({request.open_from[i], request.open_until[i]});
  }
  return gate;
}

}  // namespace

std::string serve(Episode& episode, const social_crowd::SpawnAgent::Request& request,
                  social_crowd::SpawnAgent::Response& response) {
  AgentStart start;
  start.position = {request.pose.x, request.pose.y};
  start.heading = request.pose.theta;
  start.goals = {fromPoint(request.goal)};
  start.max_speed = request.max_speed;
  start.radius = request.radius;
  response.agent = episode.edit().addAgent(start);
  return "agent " + std::to_string(response.agent) + " added at ";
}

std::string serve(Episode& episode, const social_crowd::RemoveAgent::Request& request,
                  social_crowd::RemoveAgent::Response& /*response*/) {
  episode.edit().removeAgent(request.agent);
  return "agent " + std::to_string(request.agent) + " removed at ";
}

std::string serve(Episode& episode, const social_crowd::SetGoal::Request& request,
                  social_crowd::SetGoal::Response& /*response*/) {
  episode.edit().setGoal(request.agent, fromPoint(request.goal));
  return "agent " + std::to_string(request.agent) + " has a new goal since ";
}

std::string serve(Episode& episode, const social_crowd::SpawnObstacle::Request& request,
                  social_crowd::SpawnObstacle::Response& response) {
  response.obstacle = static_cast<std::uint32_t>(
      episode.edit().spawnObstacle(fromPoint(request.position), fromVector3(request.velocity), request.radius));
  return "obstacle " + std::to_string(response.obstacle) + " added at ";
}

std::string serve(Episode& episode, const social_crowd::RemoveObstacle::Request& request,
                  social_crowd::RemoveObstacle::Response& /*response*/) {
  episode.edit().removeObstacle(request.obstacle);
  return "obstacle " + std::to_string(request.obstacle) + " removed at ";
}

std::string serve(Episode& episode, const social_crowd::MoveObstacle::Request& request,
                  social_crowd::MoveObstacle::Response& /*response*/) {
  episode.edit().moveObstacle(request.obstacle, fromPoint(request.position));
  return "obstacle " + std::to_string(request.obstacle) + " moved at ";
}

std::string serve(Episode& episode, const social_crowd::Teleport::Request& request,
                  social_crowd::Teleport::Response& /*response*/) {
  episode.edit().teleport(request.agent, {{request.pose.x, request.pose.y}, request.pose.theta});
  return "agent " + std::to_string(request.agent) + " moved at ";
}

std::string serve(Episode& episode, const social_crowd::TeleportRobot::Request& request,
                  social_crowd::TeleportRobot::Response& /*response*/) {
  const RobotId robot = episode.world().robots().idOf(request.robot);
  episode.edit().teleportRobot(robot, {{request.pose.x, request.pose.y}, request.pose.theta});
  return "robot " + request.robot + " moved at ";
}

std::string serve(Episode& episode, const social_crowd::AddWall::Request& request,
                  social_crowd::AddWall::Response& response) {
  response.wall =
      static_cast<std::uint32_t>(episode.edit().addWall({fromPoint(request.begin), fromPoint(request.end)}));
  return "wall " + std::to_string(response.wall) + " added at ";
}

std::string serve(Episode& episode, const social_crowd::RemoveWall::Request& request,
                  social_crowd::RemoveWall::Response& /*response*/) {
  episode.edit().removeWall(request.wall);
  return "wall " + std::to_string(request.wall) + " removed at ";
}

std::string serve(Episode& episode, const social_crowd::SetRoute::Request& request,
                  social_crowd::SetRoute::Response& /*response*/) {
  episode.edit().setRoute(request.agent, request.route);
  return "agent " + std::to_string(request.agent) + " is on the route " + request.route + " since ";
}

std::string serve(Episode& episode, const social_crowd::AddSource::Request& request,
                  social_crowd::AddSource::Response& response) {
  response.source = static_cast<std::uint32_t>(episode.edit().addSource(sourceOf(request, episode)));
  return "source " + std::to_string(response.source) + " added at ";
}

std::string serve(Episode& episode, const social_crowd::Alarm::Request& request,
                  social_crowd::Alarm::Response& response) {
  response.agents = static_cast<std::uint32_t>(episode.edit().raiseAlarm(alarmOf(request, episode)));
  const std::string people = std::to_string(response.agents) + (response.agents == 1 ? " person" : " people");
  return people + (request.sink.empty() ? " walk at another speed since " : " walk to a sink since ");
}

std::string serve(Episode& episode, const social_crowd::AddGate::Request& request,
                  social_crowd::AddGate::Response& response) {
  GateDescription gate = gateOf(request);
  if (gate.name.empty()) gate.name = newGateName(episode);
  episode.edit().addGate(gate);
  response.gate = gate.name;
  return "gate " + gate.name + " added at ";
}

std::string serve(Episode& episode, const social_crowd::SetGate::Request& request,
                  social_crowd::SetGate::Response& /*response*/) {
  const bool open = request.open != 0;
  const bool is_open = episode.edit().setGate(request.gate, open);
  const std::string done = open ? " opened at " : " closed at ";
  return "gate " + request.gate + (is_open == open ? done : " closes when no agent stands in it, since ");
}

}  // namespace crowd
