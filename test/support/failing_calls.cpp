// A library for LD_PRELOAD with which calls for files, and allocations, of a program fail. Environment variables:
// CALLS_FOLDER: calls for what is in it count; the program runs in it. CALLS_LOG: file to which they are appended.
// CALLS_FAIL: number of the one that fails, from 1. CALLS_ALLOCATION: the same for allocations after the first of these
// calls. CALLS_ERROR: errno of the failing call, 0: it reads or writes half of the bytes. CALLS_ON: if set, all later
// ones fail as well. A line of the log has, separated by tabs, the kind of call, its path, a second path or "FAILS",
// and the written bytes, or those of a size, as hexadecimal digits; the last one has the number of allocations.

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

// NOLINTBEGIN

extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
}

namespace {

std::atomic<long> calls{0};
std::atomic<long> allocations{0};

long number(const char* variable, long otherwise) {
  const char* const text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atol(text);
}

bool isChosen(const char* variable, long count) {
  const long chosen = number(variable, 0);
  return chosen > 0 && (count == chosen || (count > chosen && std::getenv("CALLS_ON") != nullptr));
}

bool hasNoMemory() {
  if (calls == 0 || !isChosen("CALLS_ALLOCATION", ++allocations)) return false;
  errno = ENOMEM;
  return true;
}

/// Whether a path is in the folder; relative ones are, as the program runs in it. Other names are those of pipes.
bool counts(const char* path) {
  const char* const folder = std::getenv("CALLS_FOLDER");
  if (folder == nullptr || std::strchr(path, ':') != nullptr) return false;
  return path[0] != '/' || std::strncmp(path, folder, std::strlen(folder)) == 0;
}

void log(const char* kind, const char* path, const char* other, const unsigned char* bytes, size_t size) {
  const char* const file = std::getenv("CALLS_LOG");
  if (file == nullptr) return;
  static char line[1 << 20];
  int end = std::snprintf(line, sizeof(line), "%s\t%s\t%s\t", kind, path, other);
  for (size_t i = 0; bytes != nullptr && i < size && end + 4U < sizeof(line); ++i) {
    end += std::snprintf(line + end, sizeof(line) - end, "%02x", bytes[i]);
  }
  line[end++] = '\n';
  const long opened = ::syscall(SYS_open, file, O_WRONLY | O_CREAT | O_APPEND, 0666);
  ::syscall(SYS_write, opened, line, end);
  ::syscall(SYS_close, opened);
}

/// Counts a call. Returns whether it is to fail, with errno set.
bool fails(const char* kind, const char* path, const char* other = "", const void* bytes = nullptr, size_t size = 0) {
  if (!counts(path)) return false;
  const int before = errno;
  const bool chosen = isChosen("CALLS_FAIL", ++calls);
  log(kind, path, chosen ? "FAILS" : other, static_cast<const unsigned char*>(bytes), size);
  errno = chosen ? static_cast<int>(number("CALLS_ERROR", EIO)) : before;
  return chosen;
}

bool fails(const char* kind, int opened, const void* bytes = nullptr, size_t size = 0) {
  if (std::getenv("CALLS_FOLDER") == nullptr) return false;
  char link[64];
  char path[PATH_MAX] = "";
  std::snprintf(link, sizeof(link), "/proc/self/fd/%d", opened);
  ::syscall(SYS_readlink, link, path, sizeof(path) - 1);
  return fails(kind, path, "", bytes, size);
}

int openFile(int folder, const char* path, int flags, va_list rest) {
  const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, mode_t) : 0;
  const char* const kind = (flags & O_TRUNC) != 0 ? "truncate" : (flags & O_CREAT) != 0 ? "create" : "open";
  return fails(kind, path) ? -1 : ::syscall(SYS_openat, folder, path, flags, mode);
}

[[gnu::destructor]] void logAllocations() {
  log("allocations", "", std::to_string(allocations.load()).c_str(), nullptr, 0);
}

}  // namespace

// A function of the C library under its name; the others call the next library that has it.
#define NEXT(name) reinterpret_cast<decltype(&name)>(::dlsym(RTLD_NEXT, #name))
#define WRAP(result, name, parameters, arguments, failure, ...)  \
  result name parameters {                                       \
    static const auto REAL = NEXT(name);                         \
    return fails(#name, __VA_ARGS__) ? failure : REAL arguments; \
  }
#define TRANSFER(name, type, bytes)                                          \
  ssize_t name(int opened, type data, size_t size) {                         \
    static const auto REAL = NEXT(name);                                     \
    if (!fails(#name, opened, bytes, size)) return REAL(opened, data, size); \
    return errno != 0 ? -1 : REAL(opened, data, (size + 1) / 2);             \
  }
#define OPEN(name, parameters, folder)                      \
  int name parameters {                                     \
    va_list rest;                                           \
    va_start(rest, flags);                                  \
    const int opened = openFile(folder, path, flags, rest); \
    va_end(rest);                                           \
    return opened;                                          \
  }

extern "C" {

OPEN(open, (const char* path, int flags, ...), AT_FDCWD)
OPEN(open64, (const char* path, int flags, ...), AT_FDCWD)
OPEN(openat, (int folder, const char* path, int flags, ...), folder)
OPEN(openat64, (int folder, const char* path, int flags, ...), folder)
WRAP(DIR*, opendir, (const char* path), (path), nullptr, path)
TRANSFER(read, void*, nullptr)
TRANSFER(write, const void*, data)
WRAP(ssize_t, pread, (int opened, void* data, size_t size, off_t place), (opened, data, size, place), -1, opened)
WRAP(int, flock, (int opened, int mode) noexcept, (opened, mode), -1, opened)
WRAP(int, fchmod, (int opened, mode_t mode) noexcept, (opened, mode), -1, opened)
WRAP(int, fchown, (int opened, uid_t user, gid_t group) noexcept, (opened, user, group), -1, opened)
WRAP(int, ftruncate, (int opened, off_t size) noexcept, (opened, size), -1, opened, &size, sizeof(size))
WRAP(int, posix_fallocate, (int opened, off_t place, off_t size), (opened, place, size), errno, opened)
WRAP(int, rename, (const char* path, const char* to) noexcept, (path, to), -1, path, to)
WRAP(int, unlink, (const char* path) noexcept, (path), -1, path)
WRAP(int, mkdir, (const char* path, mode_t mode) noexcept, (path, mode), -1, path)
WRAP(int, access, (const char* path, int mode) noexcept, (path, mode), -1, path)
WRAP(int, stat, (const char* path, struct stat* status) noexcept, (path, status), -1, path)
WRAP(int, lstat, (const char* path, struct stat* status) noexcept, (path, status), -1, path)
WRAP(int, fstat, (int opened, struct stat* status) noexcept, (opened, status), -1, opened)
WRAP(int, stat64, (const char* path, struct stat64* status) noexcept, (path, status), -1, path)
WRAP(int, lstat64, (const char* path, struct stat64* status) noexcept, (path, status), -1, path)
WRAP(int, fstat64, (int opened, struct stat64* status) noexcept, (opened, status), -1, opened)

/// No disk is flushed, which takes long: the power does not fail here.
int fsync(int opened) { return fails("fsync", opened) ? -1 : 0; }
int fdatasync(int opened) { return fails("fsync", opened) ? -1 : 0; }

/// A close that fails has closed the file, as on Linux.
int close(int opened) {
  const bool failed = fails("close", opened);
  const int reason = errno;
  const int result = static_cast<int>(::syscall(SYS_close, opened));
  if (failed) errno = reason;
  return failed ? -1 : result;
}

void* malloc(size_t size) noexcept { return hasNoMemory() ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) noexcept { return hasNoMemory() ? nullptr : __libc_calloc(count, size); }
void* realloc(void* memory, size_t size) noexcept { return hasNoMemory() ? nullptr : __libc_realloc(memory, size); }
void* aligned_alloc(size_t alignment, size_t size) noexcept {
  return hasNoMemory() ? nullptr : __libc_memalign(alignment, size);
}

}  // extern "C"

// NOLINTEND
