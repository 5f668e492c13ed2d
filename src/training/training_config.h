#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/files/files.h"
#include "learning/learner.h"
#include "learning/model.h"
#include "learning/rl/learning_parameters.h"

namespace crowd {

/// @brief Scenarios and schedule of a training.
struct TrainingPlan {
  /// Paths of existing files; episodes cycle through the documents of all files.
  std::vector<std::string> scenarios;
  std::uint64_t episodes = 0;
  std::uint64_t seed = 1;
  TableUse tables = TableUse::SHARED;
  std::uint64_t save_every = 0;    ///< interval between saves [episodes]; 0: at the end only
  std::uint32_t side_by_side = 1;  ///< number of learners, each with its own copy of the table
  std::uint32_t turn = 10;         ///< episodes of each learner between two merges of the copies
};

/// @brief A training configuration file (config/learning/*.yaml): model, learning parameters and training plan.
struct TrainingConfig {
  Model model;
  LearningPlan learning;
  TrainingPlan training;
};

/// @brief Reads a configuration file. Its scenarios are paths relative to the file, or names of shipped scenarios
/// (findScenario()).
/// @throws FileError; InputError with file, line and the expected value.
TrainingConfig readTrainingConfig(const std::string& file, FileKinds kinds = FileKinds::REGULAR);

}  // namespace crowd
