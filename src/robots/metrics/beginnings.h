#pragma once

#include <cstdint>

namespace crowd {

/// @brief Counts how often something is there that was not there in the tick before.
struct Beginnings {
  std::uint64_t count = 0;
  bool is_there = false;

  void add(bool now) {
    count += now && !is_there ? 1 : 0;
    is_there = now;
  }
};

}  // namespace crowd
