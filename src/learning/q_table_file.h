#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "common/files/files.h"
#include "learning/model.h"
#include "learning/rl/learning_parameters.h"
#include "learning/rl/q_table.h"

namespace crowd {

/// @brief Contents of a Q-table file: a Q-table with its model and how it was learned.
struct TrainedTable {
  Model model;
  LearningParameters parameters;
  std::uint64_t decisions = 0;  ///< number of decisions that it was learned from
  std::uint64_t seed = 0;       ///< seed of the training
  QTable table;
};

/// @brief Returns the text of a Q-table file (docs/q_tables.md, "Q-table files"): a header of YAML lines, one line per
/// visited row, the visits of foreign sources if there are any, and a checksum.
/// @throws InputError if a value is not finite
std::string toText(const TrainedTable& trained);

/// @brief Returns how many characters toText() has at most while the table goes on learning.
std::uint64_t maxTextSize(const TrainedTable& trained);

/// @brief Parses the text that toText() wrote; values are restored bit for bit.
/// @param name name of the file in messages
/// @param expected a model that the table must fit, which is checked before memory for its rows is taken; null: any
/// @throws InputError with the line if anything is invalid, missing, duplicate, out of range or left over; ShapeError
TrainedTable parseQTable(const std::string& text, const std::string& name, const Model* expected = nullptr);

/// @brief Writes a Q-table file atomically: to a temporary file in the same folder, flushed to disk, then renamed. A
/// failure leaves an existing file unchanged. @throws FileError, InputError as toText() does
void saveQTable(const std::string& file, const TrainedTable& trained);

/// @brief Reads a Q-table file. @param expected as above @throws FileError, InputError, ShapeError
TrainedTable loadQTable(const std::string& file, FileKinds kinds = FileKinds::REGULAR, const Model* expected = nullptr);

}  // namespace crowd
