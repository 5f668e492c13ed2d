#pragma once

#include <string>

#include "common/files/descriptor.h"

namespace crowd {

/// @brief Keeps other processes from a file as long as it lives: those that use a FileLock, too. The lock is the file
/// NAME.lock beside it. The kernel releases it when the process ends, however it ends; then the empty lock may remain.
class FileLock {
 public:
  /// @brief Takes the lock of a file, which need not exist.
  /// @throws FileError if another process has it, with its number, if the lock cannot be written, or if the file or
  /// NAME.lock is something else, such as a device or a link
  explicit FileLock(const std::string& file);
  /// @brief Releases the lock and removes NAME.lock.
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  std::string name_;
  Descriptor opened_;
};

}  // namespace crowd
