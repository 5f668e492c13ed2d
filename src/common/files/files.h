#pragma once

#include <cstdint>
#include <string>

namespace crowd {

/// @brief What readFile() reads. Reading a pipe waits for those who write into it: only where a user names a file on a
/// command line, never in a service.
enum class FileKinds { REGULAR, REGULAR_OR_PIPE };

/// @brief The largest files that are read [bytes].
struct FileLimits {
  static constexpr std::uint64_t YAML = 100'000'000;         ///< scenarios, configurations, descriptions of maps
  static constexpr std::uint64_t IMAGE = 400'000'000;        ///< as many as a P2 image with the most cells of a map has
  static constexpr std::uint64_t RECORDING = 1'000'000'000;  ///< more than lines of the most positions need
  static constexpr std::uint64_t Q_TABLE = 4'000'000'000;    ///< more than the largest practical state set needs
  static constexpr std::uint64_t ANY = 16'000'000'000;       ///< checkpoints, which may have a table for every agent
};

/// @brief Returns the content of a file.
/// @throws FileError if it cannot be read, is of another kind (folder, device, pipe) or has more than `most` bytes
std::string readFile(const std::string& file, std::uint64_t most = FileLimits::ANY,
                     FileKinds kinds = FileKinds::REGULAR);

/// @brief Replaces the content of a regular file atomically: writes a temporary file in the same folder, flushes it to
/// the disk, renames it and flushes the folder. Mode and, if permitted, owner of the file are kept; links to it stay
/// links. On failure the previous content remains. Removes temporary files of processes that were killed.
/// @throws FileError also if there is something else of that name, such as a device or a pipe
void replaceFile(const std::string& file, const std::string& content);

/// @brief Checks that replaceFile() can write a file there, by a temporary file that is removed at once.
/// @throws FileError with the reason, such as a missing folder
void requireReplaceable(const std::string& file);

/// @brief Creates a folder and its parent folders. @throws FileError
void makeFolder(const std::string& folder);

/// @brief Returns a path that is the same for all spellings of a path, such as "a", "a/", "b/../a" and a link to it; an
/// empty one stays empty.
std::string fullPath(const std::string& path);

/// @brief File name of a path without its extension: "a/b/circle6.yaml" -> "circle6".
std::string stemOf(const std::string& path);

}  // namespace crowd
