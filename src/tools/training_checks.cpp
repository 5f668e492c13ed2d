#include "training_checks.h"

#include <filesystem>
#include <utility>
#include <vector>

#include "common/files/files.h"
#include "common/files/growing_file.h"
#include "learning/q_table_file.h"
#include "social_crowd/errors.h"
#include "training/record.h"

namespace crowd {
namespace {

/// Whether a file has more than a header.
bool hasRows(const std::string& file, const std::string& header) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(file, ignored) && std::filesystem::file_size(file, ignored) > header.size();
}

/// Whether a file has anything but a table without experience.
bool hasLearned(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored) || std::filesystem::is_empty(file, ignored)) return false;
  try {
    return loadQTable(file).decisions > 0;
  } catch (const InputError&) {
    return true;
  }
}

}  // namespace

void requireWritable(const std::string& output, const TrainingFileNames& names) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"--output", output}, {"--record", names.record}, {"--log", names.log}, {"--checkpoint", names.checkpoint}};
  for (auto one = files.begin(); one != files.end(); ++one) {
    for (auto other = files.begin(); other != one; ++other) {
      if (one->second.empty() || one->second != other->second) continue;
      throw InputError(one->first + ": expected another file than that of " + other->first + ", got '" + one->second +
                       "'");
    }
  }
  if (!names.checkpoint.empty()) requireReplaceable(names.checkpoint);
  if (!names.record.empty()) requireGrowable(names.record);
  if (!names.log.empty()) requireGrowable(names.log);
}

void requireNothingLost(const std::string& output, const TrainingFileNames& names, const std::string& q_table) {
  std::string found;
  if (hasRows(names.log, LOG_HEADER)) {
    found = "--log " + names.log;
  } else if (hasRows(names.record, recordHeader())) {
    found = "--record " + names.record;
  } else if (output != q_table && hasLearned(output)) {
    found = "--output " + output;
  }
  if (found.empty()) return;
  throw InputError(names.checkpoint + ": there is no checkpoint, and " + found +
                   " has contents that would be lost: correct the name of the checkpoint; to begin anew, remove that "
                   "file or leave out --resume");
}

}  // namespace crowd
