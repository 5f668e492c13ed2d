#pragma once

#include <fstream>
#include <string>

namespace crowd {

/// @brief The whole content of a file. @throws FileError
std::string readFile(const std::string& file);

/// @brief Replaces a file's content: writes a temporary file beside it, flushes it to the disk, then renames it; what
/// was there before stays whole whatever happens. @throws FileError
void replaceFile(const std::string& file, const std::string& content);

/// @brief Checks, without writing anything, that a file can be made or replaced.
/// @throws FileError telling why not; where its folder is missing, which one that is.
void requireReplaceable(const std::string& file);

/// @brief A text file that grows while a run goes on.
class GrowingFile {
 public:
  /// @brief Begins the file anew. @throws FileError
  GrowingFile(std::string file, const std::string& first_line);
  /// @brief Appends a text and hands it to the system. @throws FileError
  void append(const std::string& text);

 private:
  std::string file_;
  std::ofstream stream_;
};

/// @brief Makes a folder and those above it. @throws FileError
void makeFolder(const std::string& folder);

/// @brief A path's last part without its ending: "a/b/circle6.yaml" -> "circle6".
std::string stemOf(const std::string& path);

}  // namespace crowd
