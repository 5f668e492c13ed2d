#include "simd/segment_gaps.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/random.h"
#include "simd/kernels.h"

namespace crowd::simd::segment_gaps_test {
namespace {

constexpr std::size_t COUNT = 8;
using Numbers = std::array<double, COUNT>;

struct Regions {
  Numbers from_xs{}, from_ys{}, to_xs{}, to_ys{}, radii{};

  void set(std::size_t i, const PlaneSegment& way, double radius) {
    from_xs[i] = way.from_x;
    from_ys[i] = way.from_y;
    to_xs[i] = way.to_x;
    to_ys[i] = way.to_y;
    radii[i] = radius;
  }
};

struct Gaps {
  Numbers normal_xs{}, normal_ys{}, widths{}, alongs{};

  bool operator==(const Gaps& other) const {
    return normal_xs == other.normal_xs && normal_ys == other.normal_ys && widths == other.widths &&
           alongs == other.alongs;
  }
};

Gaps gapsOf(const Kernels& kernels, double to_x, double to_y, double radius, const Regions& others) {
  Gaps gaps;
  kernels.find_gaps(to_x, to_y, radius,
                    {others.from_xs.data(), others.from_ys.data(), others.to_xs.data(), others.to_ys.data(),
                     others.radii.data(), COUNT},
                    {gaps.normal_xs.data(), gaps.normal_ys.data(), gaps.widths.data(), gaps.alongs.data()});
  return gaps;
}

void expectGap(const Gaps& gaps, std::size_t i, double normal_x, double normal_y, double width, double along) {
  EXPECT_NEAR(gaps.normal_xs[i], normal_x, 1e-15) << "region " << i;
  EXPECT_NEAR(gaps.normal_ys[i], normal_y, 1e-15) << "region " << i;
  EXPECT_NEAR(gaps.widths[i], width, 1e-15) << "region " << i;
  EXPECT_NEAR(gaps.alongs[i], along, 1e-15) << "region " << i;
}

TEST(FindGaps, AreThoseBetweenTheNearestPoints) {
  Regions others;
  others.set(0, {3.0, 0.0, 3.0, 0.0}, 0.5);     // stands ahead: nearest to the agent's stop at (1, 0)
  others.set(1, {-2.0, 0.0, -1.0, 0.0}, 0.25);  // comes from behind, up to 1 m from the origin
  others.set(2, {0.5, 2.0, 0.5, 1.0}, 0.25);    // comes from the left, beside the middle of the way
  others.set(3, {0.5, 1.0, 0.5, -1.0}, 0.25);   // crosses the way
  others.set(4, {4.0, 4.0, 4.0, 4.0}, 1.0);     // 3 to the right and 4 up from the stop
  others.set(5, {0.0, 0.0, 0.0, 0.0}, 0.25);    // at the origin
  others.set(6, {0.0, -1.0, 1.0, -1.0}, 0.25);  // walks beside it: all points are as near, the first is taken
  others.set(7, {2.0, 0.0, 1.5, 0.0}, 0.5);     // comes towards it, on the same line
  for (const Kernels& kernels : availableKernels()) {
    SCOPED_TRACE(kernels.target);
    const Gaps gaps = gapsOf(kernels, 1.0, 0.0, 0.25, others);
    expectGap(gaps, 0, 1.0, 0.0, 1.25, 1.0);
    expectGap(gaps, 1, -1.0, 0.0, 0.5, 0.0);
    expectGap(gaps, 2, 0.0, 1.0, 0.5, 0.0);
    expectGap(gaps, 3, 0.0, 0.0, -0.5, 0.0);
    expectGap(gaps, 4, 0.6, 0.8, 3.75, 0.6);
    expectGap(gaps, 5, 0.0, 0.0, -0.5, 0.0);
    expectGap(gaps, 6, 0.0, -1.0, 0.5, 0.0);
    expectGap(gaps, 7, 1.0, 0.0, -0.25, 1.0);
  }
}

/// Ends that coincide, are on one line, or on one another's line now and then.
PlaneSegment randomSegment(KeyedRandom& random) {
  const auto coordinate = [&random] {
    return random.below(4) == 0 ? 0.25 * random.below(5) : random.uniform(-1.0, 1.0);
  };
  const double x = coordinate();
  const double y = coordinate();
  if (random.below(5) == 0) return {x, y, x, y};
  return {x, y, coordinate(), coordinate()};
}

TEST(FindGaps, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    Regions others;
    for (std::size_t i = 0; i < COUNT; ++i) others.set(i, randomSegment(random), random.uniform(0.0, 0.4));
    const PlaneSegment own = randomSegment(random);
    const double radius = random.uniform(0.0, 0.4);
    const Gaps expected = gapsOf(REFERENCE, own.to_x, own.to_y, radius, others);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_EQ(gapsOf(kernels, own.to_x, own.to_y, radius, others), expected) << kernels.target << ", seed " << seed;
    }
  }
}

}  // namespace
}  // namespace crowd::simd::segment_gaps_test
