#include "common/descriptor.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include "social_crowd/common/errors.h"

namespace crowd {

Descriptor::~Descriptor() { close(); }

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

bool Descriptor::close() {
  const int number = std::exchange(number_, -1);
  return number < 0 || ::close(number) == 0;
}

const char* kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISCHR(mode) || S_ISBLK(mode)) return "a device";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISSOCK(mode) ? "a socket" : "a file";
}

std::string inFull(const std::string& file) {
  std::error_code problem;
  const std::filesystem::path path(file);
  if (path.empty() || path.is_absolute()) return "";
  const std::filesystem::path full = std::filesystem::absolute(path, problem).lexically_normal();
  return problem ? "" : " (that is " + full.string() + ")";
}

void throwSystem(const std::string& file, const std::string& what) {
  const std::string reason = std::strerror(errno);
  throw FileError(file + ": " + what + ": " + reason + inFull(file));
}

}  // namespace crowd
