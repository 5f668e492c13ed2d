#include <gtest/gtest.h>

#include <cmath>

#include "simd/kernels.h"
#include "support/random_moves.h"

namespace crowd::simd::following_moves_test {
namespace {

using Lanes = RandomMoves::Lanes;

TEST(CutFollowing, LimitsMovesTowardsTheLeader) {
  // Straight ahead, at 60 degrees but within the width, aside of it, away from it, and slow already.
  Lanes xs{};
  Lanes ys{};
  xs[0] = 1.0;
  xs[1] = 0.5;
  ys[1] = std::sqrt(0.75);
  ys[2] = 1.0;
  xs[3] = -1.0;
  xs[4] = 1.0;
  Lanes fractions{};
  fractions.fill(1.0);
  fractions[4] = 0.1;
  // The leader is 2 m ahead, the gap 0.3 m now, and 1.2 m later; 1.5 m are walked in the time gap, 1 m in the
  // anticipation time.
  const Leader opening{2.0, 0.0, 2.0, 1.8, 0.3 / 1.5, 1.2, 1.5, 1.0};
  Leader closing = opening;
  closing.later_gap = 0.0;
  for (const Kernels& kernels : availableKernels()) {
    Lanes cut = fractions;
    kernels.cut_following(opening, xs.data(), ys.data(), cut.size(), cut.data());
    EXPECT_NEAR(cut[0], 0.48, 1e-15) << kernels.target;  // 1.2 - 0.48 * 1 = 0.48 * 1.5
    EXPECT_NEAR(cut[1], 0.6, 1e-15) << kernels.target;   // 1.2 - 0.6 * 0.5 = 0.6 * 1.5
    EXPECT_EQ(cut[2], 1.0) << kernels.target;
    EXPECT_EQ(cut[3], 1.0) << kernels.target;
    EXPECT_EQ(cut[4], 0.1) << kernels.target;
    cut = fractions;
    kernels.cut_following(closing, xs.data(), ys.data(), cut.size(), cut.data());
    for (const std::size_t i : {0, 1}) EXPECT_NEAR(cut[i], 0.2, 1e-15) << kernels.target << ", move " << i;
  }
}

TEST(CutFollowing, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const RandomMoves moves(random);
    const double bearing = random.below(8) == 0 ? 0.0 : random.uniform(-3.2, 3.2);
    const double distance = random.below(10) == 0 ? 0.0 : random.uniform(0.1, 2.0);
    const Leader leader{distance * std::cos(bearing),
                        distance * std::sin(bearing),
                        distance,
                        random.uniform(0.0, 0.8),
                        random.below(8) == 0 ? 0.0 : random.uniform(0.0, 1.0),
                        random.below(3) == 0 ? 0.0 : random.uniform(0.0, 2.0),
                        random.uniform(0.1, 2.0),
                        random.below(8) == 0 ? 0.0 : random.uniform(0.0, 2.0)};
    Lanes expected = moves.fractions;
    REFERENCE.cut_following(leader, moves.xs.data(), moves.ys.data(), expected.size(), expected.data());
    for (const Kernels& kernels : availableKernels()) {
      Lanes cut = moves.fractions;
      kernels.cut_following(leader, moves.xs.data(), moves.ys.data(), cut.size(), cut.data());
      ASSERT_EQ(cut, expected) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd::following_moves_test
