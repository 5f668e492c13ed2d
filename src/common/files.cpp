#include "social_crowd/common/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "social_crowd/common/errors.h"

namespace crowd {
namespace {

/// " (that is /FULL/PATH)" of a relative path: a node's working directory is seldom what its user has in mind.
std::string inFull(const std::string& file) {
  std::error_code problem;
  const std::filesystem::path path(file);
  if (path.empty() || path.is_absolute()) return "";
  const std::filesystem::path full = std::filesystem::absolute(path, problem).lexically_normal();
  return problem ? "" : " (that is " + full.string() + ")";
}

[[noreturn]] void throwSystem(const std::string& file, const std::string& what) {
  const std::string reason = std::strerror(errno);
  throw FileError(file + ": " + what + ": " + reason + inFull(file));
}

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

/// Some special files claim to be larger than any memory.
constexpr std::uintmax_t MOST_RESERVED = 1U << 26U;  // [bytes]

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

std::string readFile(const std::string& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored))
    throw FileError(file + ": is a folder, expected a file" + inFull(file));
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(file.c_str(), "rb"), std::fclose);
  if (stream == nullptr) throwSystem(file, "cannot be read");
  std::string content;
  std::error_code problem;
  const std::uintmax_t size = std::filesystem::file_size(file, problem);  // unknown of what is no plain file
  if (!problem) content.reserve(std::min<std::uintmax_t>(size, MOST_RESERVED));
  std::array<char, 1U << 16U> part{};
  for (std::size_t count = part.size(); count == part.size();) {
    count = std::fread(part.data(), 1, part.size(), stream.get());
    content.append(part.data(), count);
  }
  if (std::ferror(stream.get()) != 0) throwSystem(file, "cannot be read");
  return content;
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
