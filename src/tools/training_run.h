#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "training/communicator.h"
#include "training_files.h"

namespace crowd {

/// @brief Arguments of the program `train`.
struct TrainingArguments {
  std::string config;
  std::string output;
  std::string q_table;
  std::string tables;
  TrainingFileNames files;
  double checkpoint_interval = 10.0;  // [s]
  bool resume = false;
  bool plot = false;
  std::optional<std::uint64_t> episodes;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> save_every;
  unsigned threads = 1;
};

/// @brief Trains from the beginning, or from a checkpoint, to the end or until Ctrl-C; writes all files. Collective:
/// each rank has a block of the learners; rank 0 has the files, the terminal and the messages.
/// @return the exit status, the same on all ranks @throws SharedError on all ranks
int train(Communicator& ranks, const TrainingArguments& arguments);

}  // namespace crowd
