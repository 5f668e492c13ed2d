#pragma once

#include <optional>
#include <string>
#include <vector>

#include "learning/learner.h"
#include "learning/q_table_file.h"
#include "ros/node/data_folder.h"
#include "ros/node/diagnostic_period.h"
#include "ros/node/parameters.h"

namespace crowd {

/// @brief Parameters of the node learner with their defaults.
struct LearnerParameters {
  Learner::Options options;                      ///< ~mode, ~tables, ~agents, ~share, ~shares, ~seed, ~alpha and so on
  TrainedTable table;                            ///< of ~q_table; else an empty one for the model of ~config
  TakeMethod on_share = TakeMethod::REPLACE;     ///< ~on_share: replace or merge, if a request contains no method
  std::string save_to;                           ///< ~save_to: Q-table file that is written at the end, absolute path
  DataFolder data_folder;                        ///< ~data_folder, ~allow_any_path: files that services may name
  std::uint64_t save_every = 0;                  ///< ~save_every: also written after this number of episodes; 0: never
  double diagnostic_period = DIAGNOSTIC_PERIOD;  ///< ~diagnostic_period [s]
  unsigned threads = 1;                          ///< ~threads: that share the decisions of a tick in demo mode
  std::vector<std::string> warnings;             ///< to be printed at the start
};

/// @throws InputError that lists all invalid parameters
LearnerParameters readLearnerParameters(const ros::NodeHandle& private_node);

}  // namespace crowd
