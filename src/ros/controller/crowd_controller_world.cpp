// Services of the crowd controller that change the world. Handlers access it through the main loop, between two ticks.

#include "ros/controller/crowd_controller.h"
#include "ros/controller/world_services.h"
#include "ros/messages/names.h"

namespace crowd {

template <typename Service>
void CrowdController::serveWorld(const std::string& name) {
  services_.serve<Service>(name, [this](const auto& request, auto& response) {
    loop_.ask<void>([&] { response.message = serve(*episode_, request, response) + place(); });
  });
}

void CrowdController::advertiseWorldServices() {
  serveWorld<social_crowd::SpawnAgent>(names::SPAWN_AGENT);
  serveWorld<social_crowd::RemoveAgent>(names::REMOVE_AGENT);
  serveWorld<social_crowd::SetGoal>(names::SET_GOAL);
  serveWorld<social_crowd::SpawnObstacle>(names::SPAWN_OBSTACLE);
  serveWorld<social_crowd::RemoveObstacle>(names::REMOVE_OBSTACLE);
  serveWorld<social_crowd::MoveObstacle>(names::MOVE_OBSTACLE);
  serveWorld<social_crowd::Teleport>(names::TELEPORT);
  serveWorld<social_crowd::TeleportRobot>(names::TELEPORT_ROBOT);
  serveWorld<social_crowd::AddWall>(names::ADD_WALL);
  serveWorld<social_crowd::RemoveWall>(names::REMOVE_WALL);
  serveWorld<social_crowd::SetRoute>(names::SET_ROUTE);
  serveWorld<social_crowd::AddSource>(names::ADD_SOURCE);
  serveWorld<social_crowd::Alarm>(names::ALARM);
  serveWorld<social_crowd::AddGate>(names::ADD_GATE);
  serveWorld<social_crowd::SetGate>(names::SET_GATE);
}

}  // namespace crowd
