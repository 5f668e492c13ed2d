// Services of the crowd controller that change the world. Handlers access it through the main loop, between two ticks.

#include <social_crowd/AddGate.h>
#include <social_crowd/AddSource.h>
#include <social_crowd/AddWall.h>
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

#include "social_crowd/common/quotes.h"
#include "social_crowd/ros/controller/crowd_controller.h"
#include "social_crowd/ros/messages/conversions.h"
#include "social_crowd/ros/messages/names.h"

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

void CrowdController::advertiseWorldServices() {
  services_.serve<social_crowd::SpawnAgent>(names::SPAWN_AGENT, [this](const auto& request, auto& response) {
    AgentStart start;
    start.position = {request.pose.x, request.pose.y};
    start.heading = request.pose.theta;
    start.goals = {fromPoint(request.goal)};
    start.max_speed = request.max_speed;
    start.radius = request.radius;
    loop_.ask<void>([&] {
      response.agent = episode_->spawnAgent(start);
      response.message = "agent " + std::to_string(response.agent) + " added at " + place();
    });
  });
  services_.serve<social_crowd::RemoveAgent>(names::REMOVE_AGENT, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      episode_->removeAgent(request.agent);
      response.message = "agent " + std::to_string(request.agent) + " removed at " + place();
    });
  });
  services_.serve<social_crowd::SetGoal>(names::SET_GOAL, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      episode_->setGoal(request.agent, fromPoint(request.goal));
      response.message = "agent " + std::to_string(request.agent) + " has a new goal since " + place();
    });
  });
  services_.serve<social_crowd::SpawnObstacle>(names::SPAWN_OBSTACLE, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      response.obstacle = static_cast<std::uint32_t>(
          episode_->spawnObstacle(fromPoint(request.position), fromVector3(request.velocity), request.radius));
      response.message = "obstacle " + std::to_string(response.obstacle) + " added at " + place();
    });
  });
  services_.serve<social_crowd::RemoveObstacle>(names::REMOVE_OBSTACLE, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      episode_->removeObstacle(request.obstacle);
      response.message = "obstacle " + std::to_string(request.obstacle) + " removed at " + place();
    });
  });
  services_.serve<social_crowd::MoveObstacle>(names::MOVE_OBSTACLE, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      episode_->moveObstacle(request.obstacle, fromPoint(request.position));
      response.message = "obstacle " + std::to_string(request.obstacle) + " moved at " + place();
    });
  });
  services_.serve<social_crowd::Teleport>(names::TELEPORT, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      episode_->teleport(request.agent, {{request.pose.x, request.pose.y}, request.pose.theta});
      response.message = "agent " + std::to_string(request.agent) + " moved at " + place();
    });
  });
  services_.serve<social_crowd::AddWall>(names::ADD_WALL, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      response.wall = static_cast<std::uint32_t>(episode_->addWall({fromPoint(request.begin), fromPoint(request.end)}));
      response.message = "wall " + std::to_string(response.wall) + " added at " + place();
    });
  });
  services_.serve<social_crowd::RemoveWall>(names::REMOVE_WALL, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      episode_->removeWall(request.wall);
      response.message = "wall " + std::to_string(request.wall) + " removed at " + place();
    });
  });
  advertisePopulationServices();
}

void CrowdController::advertisePopulationServices() {
  services_.serve<social_crowd::SetRoute>(names::SET_ROUTE, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      episode_->setRoute(request.agent, request.route);
      response.message =
          "agent " + std::to_string(request.agent) + " is on the route " + request.route + " since " + place();
    });
  });
  services_.serve<social_crowd::AddSource>(names::ADD_SOURCE, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      response.source = static_cast<std::uint32_t>(episode_->addSource(sourceOf(request, *episode_)));
      response.message = "source " + std::to_string(response.source) + " added at " + place();
    });
  });
  services_.serve<social_crowd::AddGate>(names::ADD_GATE, [this](const auto& request, auto& response) {
    GateDescription gate = gateOf(request);
    loop_.ask<void>([&] {
      if (gate.name.empty()) gate.name = newGateName(*episode_);
      episode_->addGate(gate);
      response.gate = gate.name;
      response.message = "gate " + gate.name + " added at " + place();
    });
  });
  services_.serve<social_crowd::SetGate>(names::SET_GATE, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] {
      const bool open = request.open != 0;
      const bool is_open = episode_->setGate(request.gate, open);
      response.message =
          "gate " + request.gate +
          (is_open == open ? (open ? " opened at " : " closed at ") : " closes when no agent stands in it, since ") +
          place();
    });
  });
}

}  // namespace crowd
