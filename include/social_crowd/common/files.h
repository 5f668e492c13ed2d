#pragma once

#include <fstream>
#include <string>

namespace crowd {

/// @brief Returns the content of a file. @throws FileError
std::string readFile(const std::string& file);

/// @brief Replaces the content of a file atomically: writes a temporary file in the same folder, flushes it to the disk
/// and renames it. On failure the previous content remains. @throws FileError
void replaceFile(const std::string& file, const std::string& content);

/// @brief Checks, without writing anything, that a file can be made or replaced.
/// @throws FileError with the reason, such as a missing folder
void requireReplaceable(const std::string& file);

/// @brief A text file to which a run appends.
class GrowingFile {
 public:
  /// @brief Creates or truncates the file and writes the first line. @throws FileError
  GrowingFile(std::string file, const std::string& first_line);
  /// @brief Appends a text and flushes it to the operating system. @throws FileError
  void append(const std::string& text);

 private:
  std::string file_;
  std::ofstream stream_;
};

/// @brief Creates a folder and its parent folders. @throws FileError
void makeFolder(const std::string& folder);

/// @brief File name of a path without its extension: "a/b/circle6.yaml" -> "circle6".
std::string stemOf(const std::string& path);

}  // namespace crowd
