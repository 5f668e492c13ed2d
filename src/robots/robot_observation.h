#pragma once

#include <limits>
#include <vector>

#include "robots/robot_senses.h"
#include "world/neighbours.h"
#include "world/world.h"

namespace crowd {

/// @brief What a robot knows and does after some ticks, without its scan; the same with and without ROS.
struct RobotObservation {
  Pose pose;                        ///< in `map`
  Twist twist;                      ///< of the last tick
  bool has_goal = false;            ///< `goal` is valid
  bool arrived = false;             ///< at its last goal
  bool blocked = false;             ///< stopped by an impact in the last tick
  Vector2 goal = Vector2::Zero();   ///< present goal, robot frame [m]
  double remaining_distance = 0.0;  ///< see Robot::remainingDistance()
  std::vector<AgentId> contacts;    ///< agents and recorded people in contact with it, each once
  std::vector<AgentId> by_robot;    ///< of these: it moved into them
  std::vector<AgentId> by_person;   ///< of these: they moved into it
  double clearance =
      std::numeric_limits<double>::infinity();  ///< from its footprint to the nearest body of a person [m]
};

/// @brief Adds the contacts of the last tick that are not in the list yet.
void addContacts(const Robot& robot, std::vector<RobotContact>& contacts);

/// @param contacts those of the ticks that are observed
RobotObservation observeRobot(const Robot& robot, const World& world, const std::vector<RobotContact>& contacts);

/// @brief The people whom a robot's laser scanner sees (RobotSenses::visibleBodies()), in the robot's frame, nearest
/// rim first: whole bodies, also of those who are partly hidden. Recorded people are among them, with the kind AGENT.
std::vector<Neighbour> visiblePeople(const World& world, RobotId robot, RobotSenses& senses);

}  // namespace crowd
