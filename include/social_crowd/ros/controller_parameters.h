#pragma once

#include <cstdint>
#include <string>

#include "social_crowd/ros/parameters.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Parameters of the node crowd_controller. The defaults stand here only.
struct ControllerParameters {
  std::string scenario;          ///< ~scenario: file, or name in ~scenario_folder; must be given
  std::string scenario_folder;   ///< ~scenario_folder: where scenarios are looked up by name
  std::uint64_t seed = 1;        ///< ~seed: of placements at random
  std::uint64_t episodes = 0;    ///< ~episodes: end after so many; 0: go on until stopped
  double pace = 1.0;             ///< ~pace: factor of real time; 0 or `fast`: as fast as possible
  bool paused = false;           ///< ~paused: begin paused
  double start_deadline = 30.0;  ///< ~start_deadline: how long to wait for learners that never answered [s]
  double answer_deadline = 1.0;  ///< ~answer_deadline: how long to wait for an answer [s], wall clock
  int misses_until_absent = 3;   ///< ~misses_until_absent: missed answers in a row until an agent is not waited for
  Vision vision;                 ///< ~vision_radius [m], ~max_bodies (0: no limit), ~occlusion
  double agents_rate = 50.0;     ///< ~agents_rate: agents and tf are told at most so often [Hz]; 0: every tick
  bool publish_tf = false;       ///< ~publish_tf: map -> agent_<id>
  bool publish_clock = false;    ///< ~publish_clock: simulated time on /clock
  std::string trajectories;      ///< ~trajectories: folder for recordings; empty: none
};

/// @throws InputError naming everything that is wrong.
ControllerParameters readControllerParameters(const ros::NodeHandle& private_node);

/// @brief The file that a scenario's name or path means.
std::string findScenario(const std::string& name_or_file, const std::string& folder);

}  // namespace crowd
