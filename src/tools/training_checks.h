#pragma once

#include <string>

#include "training_files.h"

namespace crowd {

/// @brief Checks that the table and the other files of a training are different ones, and that the others can be
/// written. Changes nothing. @throws InputError, FileError
void requireWritable(const std::string& output, const TrainingFileNames& names);

/// @brief Checks that a training with --resume, but without a checkpoint, replaces nothing that was learned: the name
/// of the checkpoint may be misspelt.
/// @param q_table table from which the training begins; it may be the file of the output
/// @throws InputError if the output, record or log has contents
void requireNothingLost(const std::string& output, const TrainingFileNames& names, const std::string& q_table);

}  // namespace crowd
