#pragma once

#include <cstddef>

namespace crowd {

/// @brief Prefetches all cache lines of an object that is read soon. Has no other effect.
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

/// @brief Prefetches one cache line; `place` may be nullptr.
inline void prefetchAt(const void* place) {
#if defined(__GNUC__)
  __builtin_prefetch(place);
#else
  static_cast<void>(place);
#endif
}

/// @brief Prefetch distance [agents] of loops that visit agents in arbitrary order.
constexpr std::size_t PREFETCH_AHEAD = 4;

}  // namespace crowd
