#include "training_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "common/files/files.h"
#include "social_crowd/errors.h"
#include "training/record.h"

namespace crowd {
namespace {

// The files in a checkpoint have the names of their options.
constexpr const char* RECORD = "--record";
constexpr const char* LOG = "--log";
/// The largest share of the time that saving may take.
constexpr double MAX_SAVING_SHARE = 0.05;

std::optional<GrowingFile> open(const std::string& file, const char* option, const std::string& header,
                                const std::map<std::string, std::uint64_t>* before) {
  if (file.empty()) return std::nullopt;
  if (before != nullptr) return GrowingFile(file, before->at(option));
  return GrowingFile(file, header);
}

/// Checks that a file is as long as it was when the checkpoint was written, or longer.
void requireRest(const std::string& file, const char* option, const Checkpoint& checkpoint, const std::string& name) {
  const auto found = checkpoint.sizes.find(option);
  const bool had_file = found != checkpoint.sizes.end();
  if (had_file == file.empty()) {
    throw InputError(name + ": the checkpoint was written " + (had_file ? "with " : "without ") + option +
                     ", go on with the same options");
  }
  if (!had_file) return;
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(file, problem);
  if (problem) throw FileError(file + ": cannot be continued: " + problem.message());
  if (size >= found->second) return;
  throw InputError(file + ": cannot be continued: expected the " + std::to_string(found->second) +
                   " bytes that it had at the checkpoint, got " + std::to_string(size));
}

}  // namespace

void requireContinuable(const TrainingFileNames& names, const Checkpoint& checkpoint) {
  requireRest(names.record, RECORD, checkpoint, names.checkpoint);
  requireRest(names.log, LOG, checkpoint, names.checkpoint);
}

TrainingFiles::TrainingFiles(TrainingFileNames names, std::string identity, double interval,
                             const std::map<std::string, std::uint64_t>* before)
    : names_(std::move(names)),
      identity_(std::move(identity)),
      interval_(interval),
      next_(Clock::now() + std::chrono::duration_cast<Clock::duration>(interval_)),
      record_(open(names_.record, RECORD, recordHeader(), before)),
      log_(open(names_.log, LOG, LOG_HEADER, before)) {}

void TrainingFiles::append(std::uint64_t first, const std::vector<LearnedEpisode>& episodes) {
  appendRows(first, episodes);
  const Clock::time_point now = Clock::now();
  if (names_.checkpoint.empty() || now < next_) return;
  due_since_ = now;
  flushRows();
}

void TrainingFiles::appendRows(std::uint64_t first, const std::vector<LearnedEpisode>& episodes) {
  if (!record_ && !log_) return;
  std::string records;
  std::string logs;
  for (const LearnedEpisode& episode : episodes) {
    if (record_) appendRecordRows(first, episode, records);
    if (log_) appendLogRow(first, episode, logs);
    ++first;
  }
  if (record_) record_->append(records);
  if (log_) log_->append(logs);
}

void TrainingFiles::saveCheckpointIfDue(const Training& training) {
  if (!due_since_) return;
  const Clock::time_point begin = *std::exchange(due_since_, std::nullopt);
  writeCheckpoint(training);
  const std::chrono::duration<double> took = Clock::now() - begin;
  const auto pause = interval_.count() > 0.0 ? std::max(interval_, took / MAX_SAVING_SHARE) : interval_;
  next_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(pause);
}

void TrainingFiles::saveCheckpoint(const Training& training) {
  if (names_.checkpoint.empty()) return;
  flushRows();
  writeCheckpoint(training);
}

/// A checkpoint must not reach the disk before the rows that it counts.
void TrainingFiles::flushRows() {
  if (record_) record_->flushToDisk();
  if (log_) log_->flushToDisk();
}

void TrainingFiles::writeCheckpoint(const Training& training) const {
  Checkpoint checkpoint{identity_, {}, training.state()};
  if (record_) checkpoint.sizes[RECORD] = record_->size();
  if (log_) checkpoint.sizes[LOG] = log_->size();
  replaceFile(names_.checkpoint, toText(checkpoint));
}

void TrainingFiles::close() {
  if (record_) record_->close();
  if (log_) log_->close();
}

}  // namespace crowd
