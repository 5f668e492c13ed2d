#include "common/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "common/files/file_access.h"
#include "common/files/files.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr off_t LONGEST_OWNER = 20;  // characters of the number of a process, or more

/// Whether a file can be a lock: a regular file without other names that has no more than the number of a process.
bool isLock(const struct stat& status) {
  return S_ISREG(status.st_mode) && status.st_nlink <= 1 && status.st_size <= LONGEST_OWNER;
}

/// Opens a lock, or makes one. What is no lock of this package is neither changed nor removed.
Descriptor openLock(const std::string& name) {
  const int flags = O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
  Descriptor opened(::open(name.c_str(), flags, 0666));  // NOLINT(*-vararg)
  struct stat status {};
  if (opened.isOpen() ? ::fstat(opened.number(), &status) != 0 : errno != ELOOP) throwUnwritable(name);
  if (opened.isOpen() && isLock(status)) return opened;
  throw FileError(name + ": cannot be written: there is something else of that name, which is no lock" + inFull(name));
}

}  // namespace

FileLock::FileLock(const std::string& file) : name_(file + ".lock") {
  requireReplaceable(file);
  for (;;) {
    opened_ = openLock(name_);
    // A file system without locks is used without them.
    if (::flock(opened_.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
      const std::string owner = readFile(name_);
      throw FileError(file + ": is in use by another process" + (owner.empty() ? "" : ", number " + owner));
    }
    if (isNameOf(name_, opened_)) break;  // else its last owner has removed it meanwhile
  }
  const std::string owner = std::to_string(::getpid());
  // The number is only for messages.
  const bool written =
      ::ftruncate(opened_.number(), 0) == 0 && ::write(opened_.number(), owner.data(), owner.size()) > 0;
  static_cast<void>(written);
}

FileLock::~FileLock() { ::unlink(name_.c_str()); }

}  // namespace crowd
