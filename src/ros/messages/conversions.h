#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Vector3.h>
#include <nav_msgs/OccupancyGrid.h>
#include <social_crowd/AgentStates.h>
#include <social_crowd/EpisodeResult.h>
#include <social_crowd/RobotResult.h>
#include <social_crowd/Scenario.h>
#include <social_crowd/Wall.h>

#include <vector>

#include "scenario/scene.h"
#include "simulation/episode_result.h"
#include "world/world.h"

/// Conversions between messages (namespace social_crowd) and core types (namespace crowd); those of every tick are in
/// tick_messages.h. Numbers are copied bit for bit. The caller sets the header of a message.
namespace crowd {

geometry_msgs::Point toPoint(const Vector2& v);
geometry_msgs::Vector3 toVector3(const Vector2& v);
/// @brief Returns the rotation of a body with `heading` [rad], counterclockwise from the x axis of the map.
geometry_msgs::Quaternion toQuaternion(double heading);
Vector2 fromPoint(const geometry_msgs::Point& point);
Vector2 fromVector3(const geometry_msgs::Vector3& vector);

/// @brief Writes agents, obstacles, tick and time; not header and episode.
void toMessage(const World& world, social_crowd::AgentStates& message);

social_crowd::RobotResult toMessage(const RobotResult& result);
/// @brief Writes the metrics of the episode, of each agent and of each robot; not header, episode, instance and counts
/// of answers.
void toMessage(const EpisodeResult& result, social_crowd::EpisodeResult& message);

/// @brief Writes the start of an episode; not header, episode and instance.
void toMessage(const Scene& scene, const World& world, social_crowd::Scenario& message);

void toMessages(const std::vector<Segment>& walls, std::vector<social_crowd::Wall>& messages);

/// @brief Writes cells, resolution, size and origin; not the header and the time. Free cells are 0, occupied ones 100,
/// unknown ones -1.
void toMessage(const OccupancyMap& map, nav_msgs::OccupancyGrid& message);
/// @brief The map of a message, see mapFromGrid(). @throws InputError unless it is valid
OccupancyMap fromMessage(const nav_msgs::OccupancyGrid& message);

}  // namespace crowd
