#pragma once

#include <cstdint>
#include <string>

#include "common/files/file_access.h"

namespace crowd {

/// @brief Returns the place of a file that is replaced as a whole.
/// @throws FileError if there is something that is no regular file
FilePlace findReplaceable(const std::string& file);

/// @brief A new file beside one that it is to replace, locked as long as it is open: one that can be locked has been
/// left by a process that was killed. Errors name the file that it is to replace.
class TemporaryFile {
 public:
  /// @brief Creates it, under a name that did not exist. @throws FileError
  TemporaryFile(const std::string& file, FilePlace place);
  /// @brief Removes it unless it has replaced the file.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const Descriptor& opened() const { return opened_; }
  /// @brief Removes its name. Returns the open file, whose space is free when it is closed.
  Descriptor removeName();
  /// @brief Takes mode and owner of the file, reaches the disk, and replaces the file. @throws FileError
  void replace();

 private:
  bool open(std::string name);
  void takeMode();

  std::string file_;
  FilePlace place_;
  std::string name_;
  Descriptor opened_;
};

/// @brief Removes the temporary files of processes that were killed while they replaced a file.
void removeLeftovers(const FilePlace& place);

/// @brief Takes space for a file that is to be replaced. Returns the open file that has it.
/// @throws FileError if there is less
Descriptor reserveSpace(const std::string& file, std::uint64_t bytes);

}  // namespace crowd
