#pragma once

#include <sanitizer/allocator_interface.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "common/stop_request.h"
#include "social_crowd/errors.h"

/// What the fuzz targets share.
namespace crowd::fuzz {

/// @brief The memory that an input may take: this, and a multiple of its size that each target states [bytes].
constexpr std::size_t FREE_MEMORY = 32'000'000;

/// @brief Ends the program if more memory than permitted is in use at the same time. There is one at a time.
class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t most) {
    static const int installed = __sanitizer_install_malloc_and_free_hooks(
        [](const volatile void* memory, std::size_t /*size*/) { note(memory, 1); },
        [](const volatile void* memory) { note(memory, -1); });
    if (installed == 0) throw std::logic_error("no hooks for malloc and free");
    most_ = static_cast<std::ptrdiff_t>(most);
    used_ = 0;
    is_active_ = true;
  }
  ~MemoryLimit() { is_active_ = false; }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

 private:
  static void note(const volatile void* memory, std::ptrdiff_t sign) {
    if (!is_active_ || memory == nullptr) return;
    used_ += sign * static_cast<std::ptrdiff_t>(
                        __sanitizer_get_allocated_size(const_cast<const void*>(memory)));  // NOLINT(*-const-cast)
    if (used_ <= most_) return;
    is_active_ = false;
    std::fprintf(stderr, "ERROR: an input takes %td bytes of memory, expected at most %td\n", used_, most_);
    std::abort();
  }

  static inline thread_local bool is_active_ = false;
  static inline thread_local std::ptrdiff_t most_ = 0;
  static inline thread_local std::ptrdiff_t used_ = 0;
};

/// @brief Calls a reader. Errors of the package are its answers to bad inputs; anything else is a finding.
/// @param size of the input @param multiple of it that may be taken in memory, beside FREE_MEMORY
template <typename Read>
int feed(std::size_t size, std::size_t multiple, const Read& read) {
  const MemoryLimit limit(FREE_MEMORY + multiple * size);
  try {
    read();
  } catch (const Error&) {
  } catch (const Stopped&) {
  }
  return 0;
}

inline std::string textOf(const std::uint8_t* data, std::size_t size) { return {data, data + size}; }

/// @brief A file in memory, for readers that take its name.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("input", 0)) {
    if (descriptor_ < 0) throw std::runtime_error("memfd_create failed");
  }
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string name() const { return "/proc/self/fd/" + std::to_string(descriptor_); }
  /// @brief Replaces its content. @return its name
  std::string write(const std::string& content) {
    const bool written = ::ftruncate(descriptor_, 0) == 0 && ::pwrite(descriptor_, content.data(), content.size(), 0) ==
                                                                 static_cast<ssize_t>(content.size());
    if (!written) throw std::runtime_error(name() + " cannot be written");
    return name();
  }

 private:
  int descriptor_;
};

/// @brief A request that is made after some looks at it: a bound of the work that does not depend on the machine.
inline StopRequest stopAfter(std::uint64_t looks) {
  return StopRequest([looks]() mutable { return looks == 0 || --looks == 0; });
}

}  // namespace crowd::fuzz
