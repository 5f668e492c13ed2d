#pragma once

#include <cstdint>
#include <string>

#include "common/files/descriptor.h"

namespace crowd {

/// @brief The file of a result that a program has only at its end. A regular file keeps its content until the result
/// replaces it; the result is written into anything else: a device, or a pipe that a process reads from the start.
class ResultFile {
 public:
  /// @brief Checks that the result can be written, and opens what is no regular file. Changes nothing. @throws
  /// FileError
  explicit ResultFile(std::string file);
  /// @brief Whether the result is written into what is there.
  bool isStream() const { return stream_.isOpen(); }
  /// @brief Keeps space on the disk free for a result of at most that many bytes. @throws FileError if there is none
  void reserve(std::uint64_t bytes);
  /// @brief Writes the result; once. @throws FileError
  void write(const std::string& result);

 private:
  std::string file_;
  Descriptor stream_;
  Descriptor reserve_;  // a file without a name that has the space
};

}  // namespace crowd
