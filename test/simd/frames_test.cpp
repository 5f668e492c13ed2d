#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "simd/kernels.h"
#include "social_crowd/common/random.h"
#include "social_crowd/world/geometry.h"

namespace crowd::simd {
namespace {

/// x, y, vx and vy of motions, one array after the other.
using Arrays = std::array<std::vector<double>, 4>;

Arrays turn(const Kernels& kernels, const std::vector<double>& rows, std::vector<std::uint32_t> wanted,
            const Frame& frame) {
  const std::size_t count = wanted.size();
  wanted.resize(count + WantedMotions::PADDING, 0);
  Arrays arrays;
  for (auto& array : arrays) array.resize(count + WantedMotions::PADDING);
  kernels.turn_into_frame({rows.data(), wanted.data(), count}, frame,
                          {arrays[0].data(), arrays[1].data(), arrays[2].data(), arrays[3].data()});
  for (auto& array : arrays) array.resize(count);
  return arrays;
}

TEST(TurnIntoFrame, XIsAheadAndYIsLeft) {
  const std::vector<double> rows = {0.0, 0.0, 1.0, 0.0, 3.0, 1.0, 0.0, 0.5, 1.0, 5.0, 0.0, 0.0};
  const Frame frame{1.0, 1.0, 0.0, 1.0};  // looks along y
  for (const Kernels& kernels : availableKernels()) {
    const Arrays turned = turn(kernels, rows, {1, 2, 0}, frame);
    SCOPED_TRACE(kernels.target);
    EXPECT_EQ(turned[0], (std::vector<double>{0.0, 4.0, -1.0}));
    EXPECT_EQ(turned[1], (std::vector<double>{-2.0, 0.0, 1.0}));
    EXPECT_EQ(turned[2], (std::vector<double>{0.5, 0.0, 0.0}));
    EXPECT_EQ(turned[3], (std::vector<double>{0.0, 0.0, -1.0}));
  }
}

TEST(TurnIntoFrame, IsTheSameOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    std::vector<double> rows(4 * (1 + random.below(30)));
    for (double& number : rows) number = random.uniform(-6.0, 6.0);
    std::vector<std::uint32_t> wanted(random.below(40));
    for (std::uint32_t& row : wanted) row = random.below(static_cast<std::uint32_t>(rows.size() / 4));
    const double x = random.uniform(-6.0, 6.0);
    const Vector2 ahead = unitVector(random.uniform(-PI, PI));
    const Frame frame{x, random.uniform(-6.0, 6.0), ahead.x(), ahead.y()};
    const Arrays expected = turn(REFERENCE, rows, wanted, frame);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_EQ(turn(kernels, rows, wanted, frame), expected) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd
