#pragma once

namespace crowd {

/// @brief Parameters of the node crowd_controller that its robots use, with their defaults.
struct RobotParameters {
  int misses_until_absent = 3;       ///< ~misses_until_absent: missed commands, or answers, in a row until absent
  bool robot_lockstep = false;       ///< ~robot_lockstep: each tick waits for the commands of the robots
  double command_deadline = 0.5;     ///< ~command_deadline: timeout for these commands [s], wall clock
  double command_period = 0.0;       ///< ~command_period: simulated time between two of them [s]; 0: every tick
  bool publish_localisation = true;  ///< ~publish_localisation: map -> odom of the robots
  double odometry_rate = 0.0;        ///< ~odometry_rate: of odom and tf of robots, simulated time [Hz]; 0: every tick
  bool visible_people_only = false;  ///< ~visible_people_only: robots track people whom their scanners see, no others
};

}  // namespace crowd
