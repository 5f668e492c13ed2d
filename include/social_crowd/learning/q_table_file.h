#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "social_crowd/learning/model.h"
#include "social_crowd/learning/rl/learning_parameters.h"
#include "social_crowd/learning/rl/q_table.h"

namespace crowd {

/// @brief A Q-table with what its numbers mean and how it was learned: what a Q-table file holds.
struct TrainedTable {
  Model model;
  LearningParameters parameters;
  std::uint64_t decisions = 0;  ///< learned from
  std::uint64_t seed = 0;
  QTable table;
};

/// @brief The text of a Q-table file (docs/learning.md, "Q-table files"): a header of YAML lines, one line a visited
/// row, where there are several sources the visits that come from each, a checksum.
std::string toText(const TrainedTable& trained);

/// @brief Reads what toText() wrote, bit for bit; `name` stands for the file in messages.
/// @throws InputError with the line, if anything is wrong, missing, repeated, out of range or left over.
TrainedTable parseQTable(const std::string& text, const std::string& name);

/// @brief Writes a Q-table file: to a temporary file beside it, flushed to the disk, then renamed; what was there
/// before stays whole whatever happens. @throws FileError
void saveQTable(const std::string& file, const TrainedTable& trained);

/// @brief Reads a Q-table file. @throws FileError, InputError
TrainedTable loadQTable(const std::string& file);

}  // namespace crowd
