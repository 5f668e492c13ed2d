#include "common/files/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>

#include "common/files/file_access.h"
#include "common/files/temporary_file.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

/// A file may claim to be larger than it is.
constexpr std::uint64_t MOST_RESERVED = 1U << 26U;  // [bytes]

[[noreturn]] void throwTooLarge(const std::string& file, const std::string& got, std::uint64_t most) {
  throw FileError(file + ": " + got + ", expected at most " + sizeText(most) + inFull(file));
}

/// Waits until a process writes into a pipe, or has closed it. From then on, reading waits too.
void waitForContent(int descriptor) {
  pollfd pipe{descriptor, POLLIN, 0};
  while (::poll(&pipe, 1, -1) < 0 && errno == EINTR) {
  }
  ::fcntl(descriptor, F_SETFL, 0);  // NOLINT(*-vararg)
}

}  // namespace

std::string readFile(const std::string& file, std::uint64_t most, FileKinds kinds) {
  // O_NONBLOCK: opening a pipe would wait for a process that writes into it.
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));  // NOLINT(*-vararg)
  struct stat status {};
  if (!opened.isOpen() || ::fstat(opened.number(), &status) != 0) throwSystem(file, "cannot be read");
  const bool is_pipe = S_ISFIFO(status.st_mode) && kinds == FileKinds::REGULAR_OR_PIPE;
  if (!S_ISREG(status.st_mode) && !is_pipe) {
    throw FileError(file + ": is " + kindOf(status.st_mode) + ", expected a file" + inFull(file));
  }
  if (is_pipe) waitForContent(opened.number());
  const std::uint64_t size = is_pipe ? 0 : static_cast<std::uint64_t>(status.st_size);
  if (size > most) throwTooLarge(file, "is " + sizeText(size), most);
  std::string content;
  content.reserve(std::min(size, MOST_RESERVED));
  std::array<char, 1U << 16U> part{};
  for (;;) {
    const ssize_t count = ::read(opened.number(), part.data(), part.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throwSystem(file, "cannot be read");
    if (count == 0) return content;
    content.append(part.data(), static_cast<std::size_t>(count));
    if (content.size() > most) throwTooLarge(file, "has more", most);
  }
}

void replaceFile(const std::string& file, const std::string& content) {
  const FilePlace place = findReplaceable(file);
  removeLeftovers(place);
  TemporaryFile temporary(file, place);
  writeAll(temporary.opened(), content, file);
  temporary.replace();
}

void requireReplaceable(const std::string& file) {
  const FilePlace place = findReplaceable(file);
  removeLeftovers(place);
  const TemporaryFile temporary(file, place);
}

void makeFolder(const std::string& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw FileError(folder + ": cannot be made: " + problem.message() + inFull(folder));
}

std::string fullPath(const std::string& path) {
  if (path.empty()) return path;
  std::error_code problem;
  const std::filesystem::path absolute = std::filesystem::absolute(path, problem);
  const std::filesystem::path followed = std::filesystem::weakly_canonical(absolute, problem);
  const std::filesystem::path full = problem ? absolute.lexically_normal() : followed;
  return (full.has_filename() ? full : full.parent_path()).string();
}

std::string stemOf(const std::string& path) { return std::filesystem::path(path).stem().string(); }

}  // namespace crowd
