#pragma once

#include <vector>

#include "scenario/robot.h"
#include "world/agent.h"
#include "world/neighbours.h"

namespace crowd {

/// @brief Protective stop of robots that yield to people.
///
/// It tests motions as they will be executed: a tick at the twist that drive and limits permit (limitTwist()), and then
/// the ticks in which the robot brakes as hard as it can, with its exact footprint. People are assumed to stand, within
/// a margin: the distance that each could walk in a tick.
///
/// As long as people stand, the robot never touches them, whatever it is commanded: either the motion that is chosen is
/// free including the margin, or the robot brakes, on a way that was tested in an earlier tick. The reserve for people
/// who walk is the margin alone.
class ProtectiveStop {
 public:
  /// @brief The twist of the coming tick: the greatest share of the commanded linear velocity with which the motion is
  /// free, and the commanded rotation if the robot may turn on the spot, else that share of it; rest if none is free.
  /// @param agents of the world; those on their way count @param recorded the recorded people who are there
  /// @param tick_duration [s]
  Twist next(const Robot& robot, const std::vector<Agent>& agents, const std::vector<Neighbour>& recorded,
             double tick_duration);

 private:
  struct Person {
    Vector2 position = Vector2::Zero();  // [m]
    double radius = 0.0;                 // margin included [m]
  };

  void findPeople(const Robot& robot, const std::vector<Agent>& agents, const std::vector<Neighbour>& recorded,
                  double tick_duration);
  bool isFree(const Robot& robot, Twist twist, double tick_duration) const;

  std::vector<Person> people_;  // near the robot
};

}  // namespace crowd
