#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "training/training.h"

namespace crowd {

/// @brief Contents of a checkpoint file, from which an interrupted training goes on.
struct Checkpoint {
  /// Lines about what the training learns, see identityOf(): only the same training goes on from it.
  std::string identity;
  /// Sizes of the files that grow with the training, by their options [bytes].
  std::map<std::string, std::uint64_t> sizes;
  TrainingState state;
};

/// @brief Returns a line for each thing on which the tables of a training depend: model, learning parameters, seed,
/// use of tables, learners side by side, and names and checksums of scenarios and maps. The number of episodes is not
/// among them. @throws FileError if a scenario file cannot be read any more
std::string identityOf(const Training& training);

/// @brief Returns the text of a checkpoint file; the format is for this program only. @throws InputError if a value of
/// a table is not finite
std::string toText(const Checkpoint& checkpoint);

/// @brief Parses a checkpoint of the same training; values are restored bit for bit.
/// @param name name of the file in messages
/// @param identity that of the training
/// @param model its model
/// @throws InputError if the text is damaged, or if it is the checkpoint of another training; the message names the
/// first difference
Checkpoint parseCheckpoint(const std::string& text, const std::string& name, const std::string& identity,
                           const Model& model);

}  // namespace crowd
