#pragma once

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

#include <string>

#include "ros/messages/names.h"
#include "simulation/episode.h"

/// Handlers of the services that change the world, between two ticks. They return what was done, up to the time.
/// A new one also belongs in visitWorldServices(). @throws InputError if the request is refused; nothing has changed
/// then
namespace crowd {

std::string serve(Episode& episode, const social_crowd::SpawnAgent::Request& request,
                  social_crowd::SpawnAgent::Response& response);
std::string serve(Episode& episode, const social_crowd::RemoveAgent::Request& request,
                  social_crowd::RemoveAgent::Response& response);
std::string serve(Episode& episode, const social_crowd::SetGoal::Request& request,
                  social_crowd::SetGoal::Response& response);
std::string serve(Episode& episode, const social_crowd::SpawnObstacle::Request& request,
                  social_crowd::SpawnObstacle::Response& response);
std::string serve(Episode& episode, const social_crowd::RemoveObstacle::Request& request,
                  social_crowd::RemoveObstacle::Response& response);
std::string serve(Episode& episode, const social_crowd::MoveObstacle::Request& request,
                  social_crowd::MoveObstacle::Response& response);
std::string serve(Episode& episode, const social_crowd::Teleport::Request& request,
                  social_crowd::Teleport::Response& response);
std::string serve(Episode& episode, const social_crowd::TeleportRobot::Request& request,
                  social_crowd::TeleportRobot::Response& response);
std::string serve(Episode& episode, const social_crowd::AddWall::Request& request,
                  social_crowd::AddWall::Response& response);
std::string serve(Episode& episode, const social_crowd::RemoveWall::Request& request,
                  social_crowd::RemoveWall::Response& response);
std::string serve(Episode& episode, const social_crowd::SetRoute::Request& request,
                  social_crowd::SetRoute::Response& response);
std::string serve(Episode& episode, const social_crowd::AddSource::Request& request,
                  social_crowd::AddSource::Response& response);
std::string serve(Episode& episode, const social_crowd::Alarm::Request& request,
                  social_crowd::Alarm::Response& response);
std::string serve(Episode& episode, const social_crowd::AddGate::Request& request,
                  social_crowd::AddGate::Response& response);
std::string serve(Episode& episode, const social_crowd::SetGate::Request& request,
                  social_crowd::SetGate::Response& response);

/// @brief Calls visit(name, service) for each of them; a service is an object that only gives the type.
template <typename Visit>
void visitWorldServices(const Visit& visit) {
  visit(names::SPAWN_AGENT, social_crowd::SpawnAgent());
  visit(names::REMOVE_AGENT, social_crowd::RemoveAgent());
  visit(names::SET_GOAL, social_crowd::SetGoal());
  visit(names::SPAWN_OBSTACLE, social_crowd::SpawnObstacle());
  visit(names::REMOVE_OBSTACLE, social_crowd::RemoveObstacle());
  visit(names::MOVE_OBSTACLE, social_crowd::MoveObstacle());
  visit(names::TELEPORT, social_crowd::Teleport());
  visit(names::TELEPORT_ROBOT, social_crowd::TeleportRobot());
  visit(names::ADD_WALL, social_crowd::AddWall());
  visit("remove_wall", social_crowd::RemoveWall());
  visit("set_route", social_crowd::SetRoute());
  visit(names::ADD_SOURCE, social_crowd::AddSource());
  visit("alarm", social_crowd::Alarm());
  visit(names::ADD_GATE, social_crowd::AddGate());
  visit("set_gate", social_crowd::SetGate());
}

}  // namespace crowd
