#pragma once

#include <optional>
#include <string>
#include <vector>

#include "social_crowd/learning/learner.h"
#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/ros/parameters.h"

namespace crowd {

/// @brief What the parameters of the node learner come to. The defaults stand here only.
struct LearnerParameters {
  Learner::Options options;                   ///< ~mode, ~tables, ~agents, ~seed, ~alpha, ~gamma, ~lambda, ~epsilon
  TrainedTable table;                         ///< of ~q_table; an empty one for the model of ~config without it
  TakeMethod on_share = TakeMethod::REPLACE;  ///< ~on_share: replace or merge, where who shares leaves it open
  std::string save_to;                        ///< ~save_to: Q-table file to write at the end, absolute
  std::uint64_t save_every = 0;               ///< ~save_every: and every so many episodes; 0: at the end only
  std::vector<std::string> warnings;          ///< what its user may not expect, to be told at the start
};

/// @throws InputError naming everything that is wrong.
LearnerParameters readLearnerParameters(const ros::NodeHandle& private_node);

}  // namespace crowd
