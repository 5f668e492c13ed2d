#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "social_crowd/ros/parameters.h"

namespace crowd {

/// @brief Parameters of the node crowd_controller. The defaults stand here only.
struct ControllerParameters {
  /// The files of ~scenario (file, or name in ~scenario_folder), or else those of ~config; one of them must be given.
  std::vector<std::string> scenarios;
  std::string name;               ///< of recordings: that of the file that ~scenario or ~config names
  std::string scenario_folder;    ///< ~scenario_folder: where scenarios have names; empty: those of the package
  std::uint64_t seed = 1;         ///< ~seed: of placements at random; else that of ~config
  std::uint64_t episodes = 0;     ///< ~episodes: number of episodes; 0: unlimited; else that of ~config
  double real_time_factor = 1.0;  ///< ~real_time_factor: factor of real time; 0 or `fast`: as fast as possible
  bool paused = false;            ///< ~paused: begin paused
  double start_deadline = 30.0;   ///< ~start_deadline: how long to wait for learners that never answered [s]
  double answer_deadline = 1.0;   ///< ~answer_deadline: how long to wait for an answer [s], wall clock
  int misses_until_absent = 3;    ///< ~misses_until_absent: missed answers in a row until an agent is not waited for
  double agents_rate = 50.0;      ///< ~agents_rate: agents and tf are told at most so often [Hz]; 0: every tick
  bool publish_tf = false;        ///< ~publish_tf: map -> agent_<id>
  bool publish_clock = false;     ///< ~publish_clock: simulated time on /clock
  std::string trajectories;       ///< ~trajectories: folder for recordings; empty: none
  bool ends_launch = false;       ///< ~ends_launch: end the roslaunch that started it after the last episode
};

/// @throws InputError naming everything that is wrong.
ControllerParameters readControllerParameters(const ros::NodeHandle& private_node);

}  // namespace crowd
