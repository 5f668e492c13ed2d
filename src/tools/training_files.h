#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/files/growing_file.h"
#include "training/checkpoint.h"
#include "training/training.h"

namespace crowd {

/// @brief The files of a training beside its table; an empty name: none.
struct TrainingFileNames {
  std::string record;
  std::string log;
  std::string checkpoint;
};

/// @brief Checks that the files of a training can go on from its checkpoint. Changes nothing.
/// @throws FileError; InputError if the checkpoint was written with other files, or if a file is shorter than it was
/// then
void requireContinuable(const TrainingFileNames& names, const Checkpoint& checkpoint);

/// @brief Writes record, log and checkpoints of a training. A checkpoint contains the sizes of the other two, so that
/// they are cut back when the training goes on from it.
class TrainingFiles {
 public:
  /// @param identity of the training, see Checkpoint
  /// @param interval time between two checkpoints [s]; 0: one after each turn
  /// @param before sizes in the checkpoint from which the training goes on; null: the files are begun anew
  /// @throws FileError
  TrainingFiles(TrainingFileNames names, std::string identity, double interval,
                const std::map<std::string, std::uint64_t>* before);

  /// @brief Appends the rows of the episodes of a turn, and flushes them to the disk if a checkpoint is due: rows that
  /// could not be flushed may be lost, although a later attempt succeeds. @param first number of the first episode.
  /// @throws FileError
  void append(std::uint64_t first, const std::vector<LearnedEpisode>& episodes);

  /// @brief Saves a checkpoint if one was due when rows were appended. @throws FileError
  void saveCheckpointIfDue(const Training& training);
  /// @brief Saves a checkpoint if there is to be one. @throws FileError
  void saveCheckpoint(const Training& training);
  /// @brief Closes record and log; once, at the end. @throws FileError
  void close();

 private:
  using Clock = std::chrono::steady_clock;

  void appendRows(std::uint64_t first, const std::vector<LearnedEpisode>& episodes);
  void flushRows();
  void writeCheckpoint(const Training& training) const;

  TrainingFileNames names_;
  std::string identity_;
  std::chrono::duration<double> interval_;
  Clock::time_point next_;                      // of the checkpoints
  std::optional<Clock::time_point> due_since_;  // if one is due
  std::optional<GrowingFile> record_;
  std::optional<GrowingFile> log_;
};

}  // namespace crowd
