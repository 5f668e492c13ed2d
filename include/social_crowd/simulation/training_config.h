#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "social_crowd/learning/learner.h"
#include "social_crowd/learning/model.h"
#include "social_crowd/learning/rl/learning_parameters.h"

namespace crowd {

/// @brief What and how to train, beside the learning itself.
struct TrainingPlan {
  std::vector<std::string>
      scenarios;  ///< files that are there; an episode takes the next document of all of them, round and round
  std::uint64_t episodes = 0;
  std::uint64_t seed = 1;
  TableUse tables = TableUse::SHARED;
  std::uint64_t save_every = 0;    ///< episodes; 0: at the end only
  std::uint32_t side_by_side = 1;  ///< learners that learn at the same time, each in a copy of the table
  std::uint32_t turn = 10;         ///< episodes of each of them until what they learned is merged
};

/// @brief A training configuration file (config/learning/*.yaml): model, learning parameters and training plan.
struct TrainingConfig {
  Model model;
  LearningPlan learning;
  TrainingPlan training;
};

/// @brief Reads a configuration file. Scenarios are files, whose paths are relative to it, or names of those that come
/// with the package (findScenario()).
/// @throws FileError; InputError with file, line and what was expected.
TrainingConfig readTrainingConfig(const std::string& file);

}  // namespace crowd
