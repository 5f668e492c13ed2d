#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/files/descriptor.h"

namespace crowd {

/// @brief What is at the place that a name stands for, behind all links.
struct FilePlace {
  std::string path;
  std::optional<struct stat> status;  ///< none: there is nothing
  int descriptor = -1;                ///< open file of this process that is meant, as by /dev/stdout; -1: none

  /// @brief Whether a text is written into what is there, such as a pipe or /dev/null, and does not replace it.
  bool isStream() const;
};

/// @brief Finds the place that a name stands for. @throws FileError if the system does not tell what is there
FilePlace findPlace(const std::string& file);

/// @brief Throws a FileError if nothing can be written there because of what it is: a folder, socket or block device.
void requireWritableKind(const std::string& file, const FilePlace& place);

/// @brief Opens a file for writing, with further flags for open(). A file of this process, as /dev/stdout, goes on
/// where it is. @throws FileError also if the file is a pipe that no process reads
Descriptor openForWriting(const std::string& file, int flags);

/// @brief Writes all bytes. Errors name `file`. @throws FileError
void writeAll(const Descriptor& opened, const std::string& content, const std::string& file);

/// @brief Flushes an open file to the disk if it has one. @throws FileError
void flushToDisk(const Descriptor& opened, const std::string& file);

/// @brief Flushes the folder of a file, so that the name of a new file is on the disk. @throws FileError
void flushFolderOf(const std::string& path, const std::string& file);

/// @brief Whether a name still stands for the file that was opened by it; links do not.
bool isNameOf(const std::string& path, const Descriptor& opened);

/// @brief Folder of a file, "." for a bare name.
std::string folderOf(const std::string& path);

/// @brief Whether there is anything but a folder, be it a pipe, or something of which the system tells nothing: reading
/// it gives the reason.
bool mayBeFile(const std::string& path);

/// @brief Names of all that is in a folder, in any order; none if it cannot be read. Unlike std::filesystem's iterator,
/// which ends the process, it throws if memory is short.
std::vector<std::string> namesIn(const std::string& folder);

/// @brief Returns "a folder", "a device", "a pipe", "a link" and so on for a mode as stat() gives it.
const char* kindOf(mode_t mode);

/// @brief Returns a number of bytes in bytes or, rounded up, in MB.
std::string sizeText(std::uint64_t bytes);

/// @brief Returns " (that is /FULL/PATH)" of a relative path, else nothing: a node's working directory is seldom what
/// its user has in mind.
std::string inFull(const std::string& file);

/// @brief Throws a FileError about a file with the reason in errno.
[[noreturn]] void throwSystem(const std::string& file, const std::string& what);

/// @brief Throws the FileError about a file that cannot be written, with the reason in errno.
[[noreturn]] void throwUnwritable(const std::string& file);

}  // namespace crowd
