#include "social_crowd/common/files.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "common/descriptor.h"
#include "social_crowd/common/errors.h"
#include "social_crowd/common/numbers.h"

namespace crowd {
namespace {

/// The folder of a file where there is none; else nothing.
std::string missingFolderOf(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::absolute(file, ignored).lexically_normal().parent_path();
  return std::filesystem::exists(folder, ignored) ? "" : folder.string();
}

[[noreturn]] void throwUnwritable(const std::string& file) {
  const int reason = errno;
  const std::string folder = reason == ENOENT ? missingFolderOf(file) : "";
  errno = reason;
  if (folder.empty()) throwSystem(file, "cannot be written");
  throw FileError(file + ": cannot be written: " + std::strerror(ENOENT) + ": there is no folder " + folder);
}

/// A file may claim to be larger than it is.
constexpr std::uint64_t MOST_RESERVED = 1U << 26U;  // [bytes]

std::string megabytes(std::uint64_t bytes) {
  constexpr std::uint64_t MANY = 10'000'000;  // bytes; more are rounded up to whole megabytes
  const double number = 1e-6 * static_cast<double>(bytes);
  return bytes > MANY ? toText(std::ceil(number)) + " MB" : toText(number) + " MB";
}

[[noreturn]] void throwTooLarge(const std::string& file, const std::string& got, std::uint64_t most) {
  throw FileError(file + ": " + got + ", expected at most " + megabytes(most) + inFull(file));
}

/// Waits until a process writes into a pipe, or has closed it. From then on, reading waits too.
void waitForContent(int descriptor) {
  pollfd pipe{descriptor, POLLIN, 0};
  while (::poll(&pipe, 1, -1) < 0 && errno == EINTR) {
  }
  ::fcntl(descriptor, F_SETFL, 0);  // NOLINT(*-vararg)
}

constexpr const char* TEMPORARY = ".tmp";  // follows the name of a file, and is followed by the number of a process

/// The file that a name stands for: a link stays a link when its file is replaced.
std::string targetOf(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path resolved = std::filesystem::canonical(file, ignored);
  return resolved.empty() ? file : resolved.string();
}

/// Writes all to a temporary file and flushes it to the disk. Errors name the file that it replaces.
void writeDurably(const std::string& temporary, const std::string& content, const std::string& file) {
  const int flags = O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC;
  const int descriptor = ::open(temporary.c_str(), flags, 0666);  // NOLINT(*-vararg)
  if (descriptor < 0) throwUnwritable(file);
  std::size_t written = 0;
  bool fine = true;
  while (fine && written < content.size()) {
    const ssize_t count = ::write(descriptor, content.data() + written, content.size() - written);
    fine = count >= 0 || errno == EINTR;
    if (count > 0) written += static_cast<std::size_t>(count);
  }
  fine = fine && ::fsync(descriptor) == 0;
  const int reason = errno;
  fine = ::close(descriptor) == 0 && fine;
  if (fine) return;
  errno = reason;
  throwUnwritable(file);
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
  if (size > most) throwTooLarge(file, "is " + megabytes(size), most);
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
  const std::string target = targetOf(file);
  const std::string temporary = target + TEMPORARY + std::to_string(::getpid());
  try {
    writeDurably(temporary, content, file);
    if (std::rename(temporary.c_str(), target.c_str()) != 0) throwSystem(file, "cannot be replaced");
  } catch (...) {
    std::remove(temporary.c_str());
    throw;
  }
}

void removeTemporaries(const std::string& file) {
  const std::filesystem::path target = targetOf(file);
  const std::string begin = target.filename().string() + TEMPORARY;
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.compare(0, begin.size(), begin) != 0) continue;
    pid_t process = 0;
    const char* const end = name.data() + name.size();
    const auto read = std::from_chars(name.data() + begin.size(), end, process);
    const bool is_ended = read.ec == std::errc() && read.ptr == end && process > 0 && ::kill(process, 0) != 0;
    if (is_ended && errno == ESRCH) std::filesystem::remove(entry.path(), ignored);
  }
}

void requireReplaceable(const std::string& file) {
  if (std::error_code ignored; std::filesystem::is_directory(file, ignored)) {
    throw FileError(file + ": cannot be written: " + std::strerror(EISDIR) + inFull(file));
  }
  std::string folder = std::filesystem::path(targetOf(file)).parent_path().string();
  if (folder.empty()) folder = ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0) throwUnwritable(file);
}

void requireGrowable(const std::string& file) {
  std::error_code ignored;
  const bool is_file = std::filesystem::exists(file, ignored) && !std::filesystem::is_directory(file, ignored);
  if (!is_file) return requireReplaceable(file);
  if (::access(file.c_str(), W_OK) != 0) throwUnwritable(file);
}

GrowingFile::GrowingFile(std::string file, const std::string& first_line)
    : file_(std::move(file)), stream_(file_, std::ios::binary | std::ios::trunc) {
  append(first_line);
}

GrowingFile::GrowingFile(std::string file, std::uint64_t size) : file_(std::move(file)), size_(size) {
  std::error_code problem;
  std::filesystem::resize_file(file_, size, problem);
  errno = problem.value();
  if (problem) throwUnwritable(file_);
  stream_.open(file_, std::ios::binary | std::ios::app);
  if (!stream_) throwUnwritable(file_);
}

void GrowingFile::append(const std::string& text) {
  stream_ << text << std::flush;
  if (!stream_) throwUnwritable(file_);
  size_ += text.size();
}

void GrowingFile::flushToDisk() {
  // Streams have no descriptor; the data of a file are the same through any of its descriptors.
  const int descriptor = ::open(file_.c_str(), O_WRONLY | O_CLOEXEC);  // NOLINT(*-vararg)
  if (descriptor < 0) throwUnwritable(file_);
  const bool fine = ::fsync(descriptor) == 0 || errno == EINVAL;  // pipes and devices have no disk
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  if (!fine) throwUnwritable(file_);
}

void makeFolder(const std::string& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw FileError(folder + ": cannot be made: " + problem.message() + inFull(folder));
}

std::string stemOf(const std::string& path) { return std::filesystem::path(path).stem().string(); }

}  // namespace crowd
