#include "social_crowd/common/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/files.h"

namespace crowd {
namespace {

int openLock(const std::string& name) {
  const int descriptor = ::open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);  // NOLINT(*-vararg)
  if (descriptor < 0) throw FileError(name + ": cannot be written: " + std::strerror(errno));
  return descriptor;
}

/// Whether the file of this name is still the one that was opened: its last owner may have removed it meanwhile.
bool isFileOf(const std::string& name, int descriptor) {
  struct stat named {};
  struct stat opened {};
  return ::stat(name.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 && named.st_ino == opened.st_ino &&
         named.st_dev == opened.st_dev;
}

}  // namespace

FileLock::FileLock(const std::string& file) : name_(file + ".lock") {
  requireReplaceable(file);
  for (;;) {
    descriptor_ = openLock(name_);
    // A file system without locks is used without them.
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      ::close(descriptor_);
      const std::string owner = readFile(name_);
      throw FileError(file + ": is in use by another process" + (owner.empty() ? "" : ", number " + owner));
    }
    if (isFileOf(name_, descriptor_)) break;
    ::close(descriptor_);
  }
  const std::string owner = std::to_string(::getpid());
  // The number is only for messages.
  const bool written = ::ftruncate(descriptor_, 0) == 0 && ::write(descriptor_, owner.data(), owner.size()) > 0;
  static_cast<void>(written);
}

FileLock::~FileLock() {
  ::unlink(name_.c_str());
  ::close(descriptor_);
}

}  // namespace crowd
