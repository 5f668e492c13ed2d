#pragma once

#include <cstddef>
#include <vector>

#include "common/random.h"

namespace crowd {

/// @brief How many of the agents of an entry walk in groups.
struct GroupShare {
  double share = 0.0;           ///< of the agents that are in groups
  std::vector<double> weights;  ///< of groups of 2, 3, 4 ... members; they need not add up to 1

  /// @brief Draws with how many others the next agent walks, itself included; 1: alone.
  std::size_t drawSize(KeyedRandom random) const;
};

}  // namespace crowd
