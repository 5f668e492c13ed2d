#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "common/random.h"

namespace crowd::simd {

/// Moves as kernels take them: unit vectors, and fractions of the maximum speed.
struct RandomMoves {
  using Lanes = std::array<double, 24>;

  /// Some of them lead straight ahead, or are not admissible.
  explicit RandomMoves(KeyedRandom& random) {
    for (std::size_t i = 0; i < xs.size(); ++i) {
      const double angle = random.below(8) == 0 ? 0.0 : random.uniform(-3.2, 3.2);
      xs[i] = std::cos(angle);
      ys[i] = std::sin(angle);
      fractions[i] = random.below(8) == 0 ? 0.0 : random.uniform(0.0, 1.0);
    }
  }

  Lanes xs{};
  Lanes ys{};
  Lanes fractions{};
};

}  // namespace crowd::simd
