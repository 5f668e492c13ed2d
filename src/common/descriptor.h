#pragma once

#include <sys/types.h>

#include <string>

namespace crowd {

/// @brief An open file of the operating system; the destructor closes it.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor();
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  bool isOpen() const { return number_ >= 0; }
  int number() const { return number_; }
  /// @brief Closes it. Returns whether there was no error; else errno has the reason.
  bool close();

 private:
  int number_;
};

/// @brief Returns "a folder", "a device", "a pipe", "a socket" or "a file" for a mode as stat() gives it.
const char* kindOf(mode_t mode);

/// @brief Returns " (that is /FULL/PATH)" of a relative path, else nothing: a node's working directory is seldom what
/// its user has in mind.
std::string inFull(const std::string& file);

/// @brief Throws a FileError about a file with the reason in errno.
[[noreturn]] void throwSystem(const std::string& file, const std::string& what);

}  // namespace crowd
