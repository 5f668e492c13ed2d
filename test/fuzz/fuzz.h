#pragma once

#include <sanitizer/allocator_interface.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <string>

#include "common/stop_request.h"
#include "social_crowd/errors.h"

/// What the fuzz targets share.
namespace crowd::fuzz {

/// @brief The memory that an input may take: this, and a multiple of its size that each target states [bytes].
constexpr std::size_t FREE_MEMORY = 32'000'000;
/// @brief The same of inputs that make or change a floor: meshes of up to 8 million cells, and 64 million grid points
/// for drawing places.
constexpr std::size_t FLOOR_MEMORY = 1'000'000'000;

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

/// @brief Time of the processor that this program has used [s]. It does not depend on the load of the machine.
inline double processorTime() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// @brief Time of the processor that an input may take [s]; with the sanitizers, it is some ten times as long.
constexpr double MOST_TIME = 10.0;

/// @brief Calls a reader. Errors of the package are its answers to bad inputs; anything else is a finding.
/// @param size of the input @param multiple of it that may be taken in memory, beside `free` [bytes]
template <typename Read>
int feed(std::size_t size, std::size_t multiple, const Read& read, std::size_t free = FREE_MEMORY) {
  const double begin = processorTime();
  try {
    const MemoryLimit limit(free + multiple * size);
    read();
  } catch (const Error&) {
  } catch (const Stopped&) {
  }
  const double time = processorTime() - begin;
  if (time > MOST_TIME) throw std::runtime_error("an input takes " + std::to_string(time) + " s");
  return 0;
}

inline std::string textOf(const std::uint8_t* data, std::size_t size) { return {data, data + size}; }

/// @brief Until a request to stop is made, which must end all work, so that an input takes much less than MOST_TIME
/// [s].
constexpr double PATIENCE = 0.1;

/// @brief A request to stop that is made after this time of the processor [s].
inline StopRequest stopAfter(double time) {
  const double end = processorTime() + time;
  return StopRequest([end] { return processorTime() > end; });
}

}  // namespace crowd::fuzz
