#include <gtest/gtest.h>

#include <cmath>

#include "simd/kernels.h"
#include "support/random_moves.h"

namespace crowd::simd::stopping_moves_test {
namespace {

using Lanes = RandomMoves::Lanes;

TEST(CutStops, TheStoppingWayFitsTheAdvance) {
  // Towards the limit, at 60 degrees to it, beside it, and away from it.
  Lanes xs{};
  Lanes ys{};
  Lanes fractions{};
  xs[0] = 1.0;
  xs[1] = 0.5;
  ys[1] = std::sqrt(0.75);
  ys[2] = 1.0;
  xs[3] = -1.0;
  fractions.fill(1.0);
  fractions[4] = 0.1;
  xs[4] = 1.0;
  // Braking 3 m/s2, tick 0.1 s, advance 0.12 m, maximum speed 1.5 m/s.
  const StopLimit limit{1.0, 0.0, 2.0 * 3.0 * 0.12, 0.3, 1.0 / 1.5};
  for (const Kernels& kernels : availableKernels()) {
    Lanes cut = fractions;
    kernels.cut_stops(limit, xs.data(), ys.data(), cut.size(), cut.data());
    EXPECT_NEAR(1.5 * cut[0], 0.6, 1e-12) << kernels.target;                           // 0.6 * 0.1 + 0.36 / 6 = 0.12
    EXPECT_NEAR(1.5 * cut[1], std::sqrt(0.09 + 1.44) - 0.3, 1e-12) << kernels.target;  // (v^2 + 0.6 v) / 12 = 0.12
    EXPECT_EQ(cut[2], 1.0) << kernels.target;
    EXPECT_EQ(cut[3], 1.0) << kernels.target;
    EXPECT_EQ(cut[4], 0.1) << kernels.target;
  }
}

TEST(CutStops, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const RandomMoves moves(random);
    const double normal = random.uniform(-3.2, 3.2);
    const double advance = random.below(8) == 0 ? 0.0 : random.uniform(-0.1, 1.0);
    const double braking = random.uniform(0.1, 10.0);
    const bool has_normal = random.below(10) > 0;
    const StopLimit limit{has_normal ? std::cos(normal) : 0.0, has_normal ? std::sin(normal) : 0.0,
                          2.0 * braking * advance, braking * random.uniform(0.01, 0.5), 1.0 / random.uniform(0.5, 2.0)};
    Lanes expected = moves.fractions;
    REFERENCE.cut_stops(limit, moves.xs.data(), moves.ys.data(), expected.size(), expected.data());
    for (const Kernels& kernels : availableKernels()) {
      Lanes cut = moves.fractions;
      kernels.cut_stops(limit, moves.xs.data(), moves.ys.data(), cut.size(), cut.data());
      ASSERT_EQ(cut, expected) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd::stopping_moves_test
