#include "common/files/file_access.h"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string_view>

#include "social_crowd/errors.h"

namespace crowd {
namespace {

namespace fs = std::filesystem;

constexpr int MAX_LINKS = 40;  // that lead to each other, as in the kernel

/// The folder of a file where there is none; else nothing.
std::string missingFolderOf(const std::string& file) {
  std::error_code ignored;
  const fs::path folder = fs::absolute(file, ignored).lexically_normal().parent_path();
  return fs::exists(folder, ignored) ? "" : folder.string();
}

/// The open file of this process that a path such as /proc/self/fd/1 stands for; -1: none.
int descriptorAt(const fs::path& path) {
  std::error_code ignored;
  const std::string name = path.filename().string();
  int number = -1;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  if (read.ec != std::errc() || read.ptr != name.data() + name.size() || number < 0) return -1;
  const fs::path own = fs::canonical("/proc/self/fd", ignored);
  return !own.empty() && fs::canonical(folderOf(path.string()), ignored) == own ? number : -1;
}

/// What is at a path itself. Errors name `file`.
FilePlace placeWithoutLinks(const fs::path& path, const std::string& file) {
  FilePlace place;
  place.path = path.string();
  place.descriptor = descriptorAt(path);
  struct stat status {};
  const bool exists =
      place.descriptor >= 0 ? ::fstat(place.descriptor, &status) == 0 : ::lstat(place.path.c_str(), &status) == 0;
  if (exists) place.status = status;
  if (!exists && errno != ENOENT && errno != ENOTDIR) throwUnwritable(file);
  return place;
}

/// A second descriptor of an open file of this process; both share their place in the file.
Descriptor copyOf(int number) {
  const int flags = ::fcntl(number, F_GETFL);  // NOLINT(*-vararg)
  if (flags >= 0 && (flags & O_ACCMODE) == O_RDONLY) errno = EBADF;
  const bool is_writable = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
  return Descriptor(is_writable ? ::fcntl(number, F_DUPFD_CLOEXEC, 0) : -1);  // NOLINT(*-vararg)
}

}  // namespace

bool FilePlace::isStream() const { return descriptor >= 0 || (status && !S_ISREG(status->st_mode)); }

FilePlace findPlace(const std::string& file) {
  std::error_code ignored;
  FilePlace place = placeWithoutLinks(file, file);
  for (int links = 0; links < MAX_LINKS && place.status && S_ISLNK(place.status->st_mode); ++links) {
    const fs::path path(place.path);
    // An absolute target replaces the folder.
    place = placeWithoutLinks(path.parent_path() / fs::read_symlink(path, ignored), file);
  }
  return place;
}

void requireWritableKind(const std::string& file, const FilePlace& place) {
  if (!place.status) return;
  const mode_t mode = place.status->st_mode;
  if (S_ISDIR(mode)) {
    errno = EISDIR;
    throwUnwritable(file);
  }
  if (S_ISREG(mode) || S_ISFIFO(mode) || S_ISCHR(mode) || place.descriptor >= 0) return;
  throw FileError(file + ": cannot be written: is " + kindOf(mode) + inFull(file));
}

Descriptor openForWriting(const std::string& file, int flags) {
  const FilePlace place = findPlace(file);
  requireWritableKind(file, place);
  if (place.descriptor >= 0) {
    Descriptor copy = copyOf(place.descriptor);
    if (!copy.isOpen()) throwUnwritable(file);
    return copy;
  }
  // O_NONBLOCK: opening a pipe would wait for a process that reads it.
  const int all_flags = O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC | flags;
  Descriptor opened(::open(file.c_str(), all_flags, 0666));  // NOLINT(*-vararg)
  if (!opened.isOpen() && errno == ENXIO && place.status && S_ISFIFO(place.status->st_mode)) {
    throw FileError(file + ": cannot be written: is a pipe that no process reads" + inFull(file));
  }
  if (!opened.isOpen()) throwUnwritable(file);
  ::fcntl(opened.number(), F_SETFL, flags & O_APPEND);  // NOLINT(*-vararg)
  return opened;
}

void writeAll(const Descriptor& opened, const std::string& content, const std::string& file) {
  std::size_t written = 0;
  while (written < content.size()) {
    const ssize_t count = ::write(opened.number(), content.data() + written, content.size() - written);
    if (count >= 0) {
      written += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {  // a file that this process got from another one may not wait
      pollfd space{opened.number(), POLLOUT, 0};
      ::poll(&space, 1, -1);
    } else if (errno != EINTR) {
      throwUnwritable(file);
    }
  }
}

void flushToDisk(const Descriptor& opened, const std::string& file) {
  // Pipes and devices have no disk.
  if (::fsync(opened.number()) != 0 && errno != EINVAL && errno != ENOTSUP) throwUnwritable(file);
}

void flushFolderOf(const std::string& path, const std::string& file) {
  const Descriptor folder(::open(folderOf(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));  // NOLINT(*-vararg)
  if (!folder.isOpen() && errno == EACCES) return;  // it may be written, but not read
  if (!folder.isOpen()) throwUnwritable(file);
  flushToDisk(folder, file);
}

bool isNameOf(const std::string& path, const Descriptor& opened) {
  struct stat named {};
  struct stat found {};
  return ::lstat(path.c_str(), &named) == 0 && ::fstat(opened.number(), &found) == 0 && named.st_ino == found.st_ino &&
         named.st_dev == found.st_dev;
}

std::string folderOf(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

bool mayBeFile(const std::string& path) {
  std::error_code ignored;
  const fs::file_type type = fs::status(path, ignored).type();
  return type != fs::file_type::not_found && type != fs::file_type::directory;
}

std::vector<std::string> namesIn(const std::string& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> opened(::opendir(folder.c_str()), &::closedir);
  std::vector<std::string> names;
  while (const dirent* entry = opened ? ::readdir(opened.get()) : nullptr) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  return names;
}

const char* kindOf(mode_t mode) {
  if (S_ISREG(mode)) return "a file";
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISCHR(mode)) return "a device";
  if (S_ISBLK(mode)) return "a block device";
  if (S_ISFIFO(mode)) return "a pipe";
  return S_ISLNK(mode) ? "a link" : "a socket";
}

std::string sizeText(std::uint64_t bytes) {
  constexpr std::uint64_t MEGABYTE = 1'000'000;
  if (bytes < MEGABYTE) return std::to_string(bytes) + " bytes";
  return std::to_string(bytes / MEGABYTE + (bytes % MEGABYTE > 0 ? 1 : 0)) + " MB";
}

std::string inFull(const std::string& file) {
  std::error_code problem;
  const fs::path path(file);
  if (path.empty() || path.is_absolute()) return "";
  const fs::path full = fs::absolute(path, problem).lexically_normal();
  return problem ? "" : " (that is " + full.string() + ")";
}

void throwSystem(const std::string& file, const std::string& what) {
  const std::string reason = std::strerror(errno);
  throw FileError(file + ": " + what + ": " + reason + inFull(file));
}

void throwUnwritable(const std::string& file) {
  const int reason = errno;
  const std::string folder = reason == ENOENT ? missingFolderOf(file) : "";
  errno = reason;
  if (folder.empty()) throwSystem(file, "cannot be written");
  throw FileError(file + ": cannot be written: " + std::strerror(ENOENT) + ": there is no folder " + folder);
}

}  // namespace crowd
