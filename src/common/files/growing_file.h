#pragma once

#include <cstdint>
#include <string>

#include "common/files/descriptor.h"

namespace crowd {

/// @brief Checks that a GrowingFile can be made there, or continue the file. Changes nothing. @throws FileError
void requireGrowable(const std::string& file);

/// @brief A text file to which a run appends. It may also be a device, or a pipe that a process reads.
class GrowingFile {
 public:
  /// @brief Creates or truncates the file and writes the first line. @throws FileError
  GrowingFile(std::string file, const std::string& first_line);
  /// @brief Continues an existing file after its first `size` bytes; the others are cut off. @throws FileError
  GrowingFile(std::string file, std::uint64_t size);
  /// @brief Appends a text. @throws FileError
  void append(const std::string& text);
  /// @brief Flushes the file and its folder to the disk. @throws FileError
  void flushToDisk();
  /// @brief Closes it; once, at the end. Some file systems report only then that they could not write. @throws
  /// FileError
  void close();
  /// @brief Number of bytes that it has.
  std::uint64_t size() const { return size_; }

 private:
  std::string file_;
  Descriptor opened_;
  bool is_new_;  // its name may not be on the disk
  std::uint64_t size_ = 0;
};

}  // namespace crowd
