#pragma once

#include <cstdint>
#include <fstream>
#include <string>

namespace crowd {

/// @brief What readFile() reads. Reading a pipe waits for those who write into it: only where a user names a file on a
/// command line, never in a service.
enum class FileKinds { REGULAR, REGULAR_OR_PIPE };

/// @brief The largest files that are read [bytes].
struct FileLimits {
  static constexpr std::uint64_t YAML = 100'000'000;       ///< scenarios, configurations, descriptions of maps
  static constexpr std::uint64_t IMAGE = 400'000'000;      ///< as many as a P2 image with the most cells of a map has
  static constexpr std::uint64_t Q_TABLE = 4'000'000'000;  ///< more than the largest practical state set needs
  static constexpr std::uint64_t ANY = 16'000'000'000;     ///< checkpoints, which may have a table for every agent
};

/// @brief Returns the content of a file.
/// @throws FileError if it cannot be read, is of another kind (folder, device, pipe) or has more than `most` bytes
std::string readFile(const std::string& file, std::uint64_t most = FileLimits::ANY,
                     FileKinds kinds = FileKinds::REGULAR);

/// @brief Replaces the content of a file atomically: writes a temporary file in the same folder, flushes it to the disk
/// and renames it. On failure the previous content remains. @throws FileError
void replaceFile(const std::string& file, const std::string& content);

/// @brief Removes the temporary files that replaceFile() left for this file in processes that were killed.
void removeTemporaries(const std::string& file);

/// @brief Checks, without writing anything, that a file can be made or replaced.
/// @throws FileError with the reason, such as a missing folder
void requireReplaceable(const std::string& file);

/// @brief Checks, without writing anything, that a GrowingFile can be made there, or continue the file. @throws
/// FileError
void requireGrowable(const std::string& file);

/// @brief A text file to which a run appends.
class GrowingFile {
 public:
  /// @brief Creates or truncates the file and writes the first line. @throws FileError
  GrowingFile(std::string file, const std::string& first_line);
  /// @brief Continues an existing file after its first `size` bytes; the others are cut off. @throws FileError
  GrowingFile(std::string file, std::uint64_t size);
  /// @brief Appends a text and flushes it to the operating system. @throws FileError
  void append(const std::string& text);
  /// @brief Flushes the file to the disk. @throws FileError
  void flushToDisk();
  /// @brief Number of bytes that it has.
  std::uint64_t size() const { return size_; }

 private:
  std::string file_;
  std::ofstream stream_;
  std::uint64_t size_ = 0;
};

/// @brief Creates a folder and its parent folders. @throws FileError
void makeFolder(const std::string& folder);

/// @brief File name of a path without its extension: "a/b/circle6.yaml" -> "circle6".
std::string stemOf(const std::string& path);

}  // namespace crowd
