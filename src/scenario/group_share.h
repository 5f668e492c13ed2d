#pragma once

#include <cstddef>
#include <vector>

#include "common/random.h"

namespace crowd {

/// @brief How many of the agents of an entry walk in groups.
struct GroupShare {
  /// Groups of a size, and their share of all groups in proportion to the other shares.
  struct Size {
    std::size_t members = 2;
    double share = 1.0;
  };
  double share = 0.0;       ///< of the agents that are in groups
  std::vector<Size> sizes;  ///< at least one, unless `share` is 0

  /// @brief Draws with how many others the next agent walks, itself included; 1: alone.
  std::size_t drawSize(KeyedRandom random) const;
};

}  // namespace crowd
