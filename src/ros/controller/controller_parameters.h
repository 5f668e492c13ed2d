#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros/node/data_folder.h"
#include "ros/node/diagnostic_period.h"
#include "ros/node/live_parameters.h"
#include "ros/node/parameters.h"
#include "ros/robots/robot_parameters.h"
#include "scenario/robot_metric_options.h"

namespace crowd {

/// @brief Parameters of the node crowd_controller with their defaults, and the ranges of all.
struct ControllerParameters : RobotParameters {
  static constexpr NumberRange REAL_TIME_FACTOR{0.0, 1e6};
  static constexpr NumberRange START_DEADLINE{0.0, 3600.0, "s"};
  static constexpr NumberRange DEADLINE{1e-3, 3600.0, "s"};  ///< for an answer or command
  static constexpr NumberRange COMMAND_PERIOD{0.0, 3600.0, "s"};
  static constexpr NumberRange MISSES{1.0, 2147483647.0};
  static constexpr NumberRange AGENTS_RATE{0.0, 1e6, "Hz"};
  static constexpr NumberRange ODOMETRY_RATE{0.0, 1e3, "Hz"};

  /// Files of ~scenario (file, or name in ~scenario_folder), else of ~config; one of these must be set.
  std::vector<std::string> scenarios;
  std::string name;                  ///< of recordings: name of the file in ~scenario or ~config
  std::string scenario_folder;       ///< ~scenario_folder: folder of named scenarios; empty: that of the package
  DataFolder data_folder;            ///< ~data_folder, ~allow_any_path: files that services may read and write
  std::string map_topic;             ///< ~map_topic: topic of a map that replaces those of the scenarios; empty: none
  std::uint64_t seed = 1;            ///< ~seed: of random placements; else that of ~config
  std::uint64_t episodes = 0;        ///< ~episodes: number of episodes; 0: unlimited; else that of ~config
  double real_time_factor = 1.0;     ///< ~real_time_factor: 0 or `fast`: as fast as possible
  bool paused = false;               ///< ~paused: start paused
  double start_deadline = 30.0;      ///< ~start_deadline: timeout for learners that never answered [s]
  double answer_deadline = 1.0;      ///< ~answer_deadline: timeout for an answer [s], wall clock
  unsigned threads = 1;              ///< ~threads: that share the agents of a tick
  double agents_rate = 50.0;         ///< ~agents_rate: maximum rate of agents and tf [Hz]; 0: every tick
  bool publish_tf = false;           ///< ~publish_tf: map -> agent_<id>
  bool publish_clock = false;        ///< ~publish_clock: simulated time on /clock
  RobotMetricOptions robot_metrics;  ///< ~progress_distance [m], ~progress_time [s], ~stalled_speed [m/s]
  std::string trajectories;          ///< ~trajectories: folder of recordings; empty: none
  std::string robot_series;          ///< ~robot_series: folder of time series of robots; empty: none
  std::string robot_logs;            ///< ~robot_logs: folder of logs of robots; empty: none
  double diagnostic_period = DIAGNOSTIC_PERIOD;  ///< ~diagnostic_period [s]
  bool ends_launch = false;                      ///< ~ends_launch: end the parent roslaunch after the last episode
};

/// @brief The factor as text, `fast` for 0.
std::string realTimeFactorText(double factor);

/// @throws InputError that lists all invalid parameters
ControllerParameters readControllerParameters(const ros::NodeHandle& private_node);

/// @brief Returns those that may change while the node runs.
LiveParameters<ControllerParameters> liveControllerParameters();

}  // namespace crowd
