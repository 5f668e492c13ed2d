#include "common/files/temporary_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <string_view>
#include <utility>

#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr std::string_view MARK = ".social_crowd.tmp";  // between the name of the file and random letters
constexpr std::string_view LETTERS = "abcdefghijklmnopqrstuvwxyz0123456789";
constexpr std::size_t LETTER_COUNT = 8;
constexpr int MAX_ATTEMPTS = 100;

std::string randomLetters() {
  std::random_device device;
  std::uniform_int_distribution<std::size_t> any(0, LETTERS.size() - 1);
  std::string letters;
  while (letters.size() < LETTER_COUNT) letters += LETTERS[any(device)];
  return letters;
}

/// Whether a file of this name can be a temporary file for another one.
bool isTemporaryOf(const std::string& target, const std::string& name) {
  const std::string begin = target + std::string(MARK);
  return name.size() == begin.size() + LETTER_COUNT && name.compare(0, begin.size(), begin) == 0 &&
         name.find_first_not_of(LETTERS, begin.size()) == std::string::npos;
}

/// Removes a temporary file that nobody has locked. Where there are no locks, it stays.
void removeIfLeft(const std::string& path) {
  const Descriptor opened(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));  // NOLINT(*-vararg)
  struct stat status {};
  if (!opened.isOpen() || ::fstat(opened.number(), &status) != 0) return;
  if (!S_ISREG(status.st_mode) || status.st_uid != ::geteuid()) return;
  if (::flock(opened.number(), LOCK_EX | LOCK_NB) == 0 && isNameOf(path, opened)) ::unlink(path.c_str());
}

/// The size of a file is also limited for each process; asking for more would end it.
std::uint64_t upToSizeLimit(std::uint64_t bytes) {
  rlimit limit{};
  const bool is_limited = ::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
  return is_limited ? std::min<std::uint64_t>(bytes, limit.rlim_cur) : bytes;
}

}  // namespace

FilePlace findReplaceable(const std::string& file) {
  FilePlace place = findPlace(file);
  requireWritableKind(file, place);
  if (!place.isStream()) return place;
  const std::string kind = place.descriptor >= 0 ? "an open file of this process" : kindOf(place.status->st_mode);
  throw FileError(file + ": cannot be replaced: is " + kind + ", expected a regular file" + inFull(file));
}

TemporaryFile::TemporaryFile(const std::string& file, FilePlace place) : file_(file), place_(std::move(place)) {
  for (int attempt = 0; attempt < MAX_ATTEMPTS; ++attempt) {
    if (open(place_.path + std::string(MARK) + randomLetters())) return;
  }
  throwUnwritable(file);
}

TemporaryFile::~TemporaryFile() {
  if (!name_.empty()) ::unlink(name_.c_str());
}

/// Returns whether it has a file of this name. Not if there is one already, or if another process has taken the new one
/// for one that was left, before it was locked.
bool TemporaryFile::open(std::string name) {
  const mode_t mode = place_.status ? 0600 : 0666;  // until it has the mode of the file
  const int flags = O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  opened_ = Descriptor(::open(name.c_str(), flags, mode));  // NOLINT(*-vararg)
  if (!opened_.isOpen() && errno == EEXIST) return false;
  if (!opened_.isOpen()) throwUnwritable(file_);
  // A file system without locks is used without them.
  const bool is_taken = ::flock(opened_.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  if (is_taken || (::access(name.c_str(), F_OK) != 0 && errno == ENOENT)) {
    errno = EEXIST;
    return false;
  }
  name_ = std::move(name);  // a copy could fail, and the file would stay
  return true;
}

Descriptor TemporaryFile::removeName() {
  ::unlink(std::exchange(name_, "").c_str());
  return std::move(opened_);
}

/// The group of the file may do nothing with the new one if that has another group.
void TemporaryFile::takeMode() {
  if (!place_.status) return;
  const struct stat& before = *place_.status;
  const bool keeps_owner = ::fchown(opened_.number(), before.st_uid, before.st_gid) == 0;
  const bool keeps_group = keeps_owner || ::fchown(opened_.number(), ::geteuid(), before.st_gid) == 0;
  const mode_t mode = before.st_mode & (keeps_group ? 0777U : 0707U);
  if (::fchmod(opened_.number(), mode) != 0) throwUnwritable(file_);
}

void TemporaryFile::replace() {
  takeMode();
  flushToDisk(opened_, file_);
  if (std::rename(name_.c_str(), place_.path.c_str()) != 0) throwSystem(file_, "cannot be replaced");
  name_.clear();
  flushFolderOf(place_.path, file_);
}

void removeLeftovers(const FilePlace& place) {
  namespace fs = std::filesystem;
  const std::string target = fs::path(place.path).filename().string();
  const fs::path folder = folderOf(place.path);
  for (const std::string& name : namesIn(folder.string())) {
    if (isTemporaryOf(target, name)) removeIfLeft((folder / name).string());
  }
}

Descriptor reserveSpace(const std::string& file, std::uint64_t bytes) {
  Descriptor opened = TemporaryFile(file, findReplaceable(file)).removeName();
  int problem = EINTR;
  while (problem == EINTR) {
    problem = ::posix_fallocate(opened.number(), 0, static_cast<off_t>(upToSizeLimit(bytes)));
  }
  if (problem != ENOSPC && problem != EDQUOT) return opened;
  throw FileError(file + ": cannot be written: " + std::strerror(problem) + ": it may need " + sizeText(bytes) +
                  inFull(file));
}

}  // namespace crowd
