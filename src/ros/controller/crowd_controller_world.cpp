// Services of the crowd controller that change the world. Handlers access it through the main loop, between two ticks.

#include <social_crowd/AddGate.h>
#include <social_crowd/AddSource.h>
#include <social_crowd/AddWall.h>
#include <social_crowd/Alarm.h>
#include <social_crowd/MoveObstacle.h>
#include <social_crowd/RemoveAgent.h>
#include <social_crowd/RemoveObstacle.h>
#include <social_crowd/RemoveWall.h>
#include <social_crowd/SetGate.h>
#include <social_crowd/SetGoal.h>
#include <social_crowd/SetRoute.h>
#include <social_crowd/SpawnAgent.h>
#include <social_crowd/SpawnObstacle.h>
#include <social_crowd/Teleport.h>
#include <social_crowd/TeleportRobot.h>

#include "common/text/quotes.h"
#include "ros/controller/crowd_controller.h"
#include "ros/messages/conversions.h"
#include "ros/messages/names.h"

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

/// Serves a service that changes the world: edit(editor, request, response) returns what was done, up to the time.
template <typename Service, typename Edit>
void CrowdController::serveEdit(const std::string& name, const Edit& edit) {
  services_.serve<Service>(name, [this, edit](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      EpisodeEditor editor(*episode_);
      response.message = edit(editor, request, response) + place();
    });
  });
}

void CrowdController::advertiseWorldServices() {
  serveEdit<social_crowd::SpawnAgent>(names::SPAWN_AGENT, [](auto& editor, const auto& request, auto& response) {
    AgentStart start;
    start.position = {request.pose.x, request.pose.y};
    start.heading = request.pose.theta;
    start.goals = {fromPoint(request.goal)};
    start.max_speed = request.max_speed;
    start.radius = request.radius;
    response.agent = editor.addAgent(start);
    return "agent " + std::to_string(response.agent) + " added at ";
  });
  serveEdit<social_crowd::RemoveAgent>(names::REMOVE_AGENT, [](auto& editor, const auto& request, auto& /*response*/) {
    editor.removeAgent(request.agent);
    return "agent " + std::to_string(request.agent) + " removed at ";
  });
  serveEdit<social_crowd::SetGoal>(names::SET_GOAL, [](auto& editor, const auto& request, auto& /*response*/) {
    editor.setGoal(request.agent, fromPoint(request.goal));
    return "agent " + std::to_string(request.agent) + " has a new goal since ";
  });
  serveEdit<social_crowd::SpawnObstacle>(names::SPAWN_OBSTACLE, [](auto& editor, const auto& request, auto& response) {
    response.obstacle = static_cast<std::uint32_t>(
        editor.spawnObstacle(fromPoint(request.position), fromVector3(request.velocity), request.radius));
    return "obstacle " + std::to_string(response.obstacle) + " added at ";
  });
  serveEdit<social_crowd::RemoveObstacle>(names::REMOVE_OBSTACLE,
                                          [](auto& editor, const auto& request, auto& /*response*/) {
                                            editor.removeObstacle(request.obstacle);
                                            return "obstacle " + std::to_string(request.obstacle) + " removed at ";
                                          });
  serveEdit<social_crowd::MoveObstacle>(names::MOVE_OBSTACLE,
                                        [](auto& editor, const auto& request, auto& /*response*/) {
                                          editor.moveObstacle(request.obstacle, fromPoint(request.position));
                                          return "obstacle " + std::to_string(request.obstacle) + " moved at ";
                                        });
  serveEdit<social_crowd::Teleport>(names::TELEPORT, [](auto& editor, const auto& request, auto& /*response*/) {
    editor.teleport(request.agent, {{request.pose.x, request.pose.y}, request.pose.theta});
    return "agent " + std::to_string(request.agent) + " moved at ";
  });
  serveEdit<social_crowd::TeleportRobot>(
      names::TELEPORT_ROBOT, [this](auto& editor, const auto& request, auto& /*response*/) {
        const RobotId robot = episode_->world().robots().idOf(request.robot);
        editor.teleportRobot(robot, {{request.pose.x, request.pose.y}, request.pose.theta});
        return "robot " + request.robot + " moved at ";
      });
  serveEdit<social_crowd::AddWall>(names::ADD_WALL, [](auto& editor, const auto& request, auto& response) {
    response.wall = static_cast<std::uint32_t>(editor.addWall({fromPoint(request.begin), fromPoint(request.end)}));
    return "wall " + std::to_string(response.wall) + " added at ";
  });
  serveEdit<social_crowd::RemoveWall>(names::REMOVE_WALL, [](auto& editor, const auto& request, auto& /*response*/) {
    editor.removeWall(request.wall);
    return "wall " + std::to_string(request.wall) + " removed at ";
  });
  serveEdit<social_crowd::SetRoute>(names::SET_ROUTE, [](auto& editor, const auto& request, auto& /*response*/) {
    editor.setRoute(request.agent, request.route);
    return "agent " + std::to_string(request.agent) + " is on the route " + request.route + " since ";
  });
  serveEdit<social_crowd::AddSource>(names::ADD_SOURCE, [this](auto& editor, const auto& request, auto& response) {
    response.source = static_cast<std::uint32_t>(editor.addSource(sourceOf(request, *episode_)));
    return "source " + std::to_string(response.source) + " added at ";
  });
  serveEdit<social_crowd::Alarm>(names::ALARM, [this](auto& editor, const auto& request, auto& response) {
    response.agents = static_cast<std::uint32_t>(editor.raiseAlarm(alarmOf(request, *episode_)));
    const std::string people = std::to_string(response.agents) + (response.agents == 1 ? " person" : " people");
    return people + (request.sink.empty() ? " walk at another speed since " : " walk to a sink since ");
  });
  serveEdit<social_crowd::AddGate>(names::ADD_GATE, [this](auto& editor, const auto& request, auto& response) {
    GateDescription gate = gateOf(request);
    if (gate.name.empty()) gate.name = newGateName(*episode_);
    editor.addGate(gate);
    response.gate = gate.name;
    return "gate " + gate.name + " added at ";
  });
  serveEdit<social_crowd::SetGate>(names::SET_GATE, [](auto& editor, const auto& request, auto& /*response*/) {
    const bool open = request.open != 0;
    const bool is_open = editor.setGate(request.gate, open);
    const std::string done = open ? " opened at " : " closed at ";
    return "gate " + request.gate + (is_open == open ? done : " closes when no agent stands in it, since ");
  });
}

}  // namespace crowd
