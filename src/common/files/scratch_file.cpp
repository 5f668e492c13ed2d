#include "common/files/scratch_file.h"

#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "social_crowd/errors.h"

namespace crowd {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw FileError("cannot " + what + " a temporary file in " P_tmpdir ": " + std::strerror(errno));
}

/// Calls transfer(done), which returns how many bytes it has transferred, until all are.
template <typename Transfer>
void transferAll(std::size_t size, const std::string& what, const Transfer& transfer) {
  for (std::size_t done = 0; done < size;) {
    const ssize_t count = transfer(done);
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) errno = EIO;  // the file ends before
    if (count <= 0) fail(what);
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace

ScratchFile::ScratchFile() : file_(std::tmpfile(), &std::fclose) {
  if (file_ == nullptr) fail("make");
}

void ScratchFile::write(std::uint64_t place, const std::vector<char>& bytes) {
  transferAll(bytes.size(), "write", [&](std::size_t done) {
    return ::pwrite(::fileno(file_.get()), &bytes[done], bytes.size() - done, static_cast<off_t>(place + done));
  });
}

void ScratchFile::read(std::uint64_t place, std::vector<char>& bytes) const {
  transferAll(bytes.size(), "read", [&](std::size_t done) {
    return ::pread(::fileno(file_.get()), &bytes[done], bytes.size() - done, static_cast<off_t>(place + done));
  });
}

}  // namespace crowd
