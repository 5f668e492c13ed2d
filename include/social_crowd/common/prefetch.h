#pragma once

#include <cstddef>

namespace crowd {

/// @brief Asks for an object that is needed soon, so that nobody waits for the memory then. Changes nothing.
template <typename Object>
inline void prefetch(const Object& object) {
#if defined(__GNUC__)
  constexpr std::size_t CACHE_LINE = 64;  // [bytes]
  const auto* const first = reinterpret_cast<const char*>(&object);
  for (std::size_t offset = 0; offset < sizeof(Object); offset += CACHE_LINE) __builtin_prefetch(first + offset);
#else
  static_cast<void>(object);
#endif
}

/// @brief The same for what lies in one cache line, or nowhere (nullptr).
inline void prefetchAt(const void* place) {
#if defined(__GNUC__)
  __builtin_prefetch(place);
#else
  static_cast<void>(place);
#endif
}

/// @brief So many agents ahead objects are asked for in loops over agents in any order.
constexpr std::size_t PREFETCH_AHEAD = 4;

}  // namespace crowd
