// Services of the crowd controller that change the world. Handlers access it through the main loop, between two ticks.

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

#include "social_crowd/ros/conversions.h"
#include "social_crowd/ros/crowd_controller.h"
#include "social_crowd/ros/names.h"

namespace crowd {
namespace {

/// Moves an obstacle to another place; it keeps its velocity. @return its new number
/// @throws InputError as Episode does; nothing has changed then
std::size_t moveObstacle(Episode& episode, std::size_t number, const Vector2& position) {
  const World& world = episode.world();
  if (number >= world.obstacles().size()) episode.removeObstacle(number);  // throws
  const double radius = world.obstacles()[number].radius;
  const ObstaclePath::Motion motion = world.obstacles()[number].path.at(world.time());
  const bool keeps = world.obstacles()[number].path.kind() == ObstaclePath::Kind::STRAIGHT;
  const std::size_t moved = episode.spawnObstacle(position, keeps ? motion.velocity : Vector2(Vector2::Zero()), radius);
  episode.removeObstacle(number);
  return moved - 1;
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
      response.obstacle =
          static_cast<std::uint32_t>(moveObstacle(*episode_, request.obstacle, fromPoint(request.position)));
      response.message = "obstacle " + std::to_string(request.obstacle) + " moved, and is obstacle " +
                         std::to_string(response.obstacle) + " now, at " + place();
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
