#pragma once

#include <vector>

#include "common/random.h"

namespace crowd {

/// @brief Draws one of these shares, at least one, with probabilities in proportion to their `share`.
template <typename Share>
const Share& drawShare(const std::vector<Share>& shares, KeyedRandom& random) {
  double sum = 0.0;
  for (const Share& each : shares) sum += each.share;
  double rest = sum * random.uniform();
  for (const Share& each : shares) {
    rest -= each.share;
    if (rest < 0.0) return each;
  }
  return shares.back();  // by rounding
}

}  // namespace crowd
