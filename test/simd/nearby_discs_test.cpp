#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "common/random.h"
#include "simd/kernels.h"

namespace crowd::simd::nearby_discs_test {
namespace {

constexpr std::uint32_t NO_BODY = std::numeric_limits<std::uint32_t>::max();
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

/// Discs, followed by padding that must not affect the result.
struct Discs {
  std::vector<double> xs, ys, radii;
  std::vector<std::uint32_t> bodies;

  explicit Discs(std::size_t count)
      : xs(count + DiscArrays::PADDING),
        ys(count + DiscArrays::PADDING),
        radii(count + DiscArrays::PADDING),
        bodies(count + DiscArrays::PADDING) {}
  std::size_t size() const { return xs.size() - DiscArrays::PADDING; }
  DiscArrays arrays() const { return {xs.data(), ys.data(), radii.data(), bodies.data()}; }
};

/// The output of a kernel: indices and rim distances.
struct Collected {
  std::vector<std::uint64_t> discs;
  std::vector<double> rims;

  bool operator==(const Collected& other) const { return discs == other.discs && rims == other.rims; }
};

Collected collect(const Kernels& kernels, const Discs& discs, const std::vector<DiscRange>& ranges,
                  const Circle& circle) {
  std::size_t room = DiscArrays::PADDING;
  for (const DiscRange& range : ranges) room += range.end - range.begin;
  Collected collected{std::vector<std::uint64_t>(room), std::vector<double>(room)};
  std::size_t count = 0;
  for (const DiscRange& range : ranges) {
    count =
        kernels.collect_nearby(discs.arrays(), range, circle, count, {collected.discs.data(), collected.rims.data()});
  }
  collected.discs.resize(count);
  collected.rims.resize(count);
  return collected;
}

TEST(CollectNearby, WritesIndicesAndRimDistancesInOrder) {
  Discs discs(4);
  discs.xs = {4.0, 1.0, 0.0, 10.0};
  discs.ys = {3.0, 0.0, 0.0, 0.0};
  discs.radii = {0.5, 0.25, 1.0, 0.5};
  discs.bodies = {7, 8, 9, 10};
  for (auto* list : {&discs.xs, &discs.ys, &discs.radii}) list->resize(4 + DiscArrays::PADDING);
  discs.bodies.resize(4 + DiscArrays::PADDING, 11);
  for (const Kernels& kernels : availableKernels()) {
    SCOPED_TRACE(kernels.target);
    EXPECT_TRUE(collect(kernels, discs, {{0, 4}}, {0.0, 0.0, 4.5, 8}) == (Collected{{0, 2}, {4.5, -1.0}}));
    EXPECT_TRUE(collect(kernels, discs, {{1, 2}, {3, 3}, {0, 1}}, {0.0, 0.0, 6.0, NO_BODY}) ==
                (Collected{{1, 0}, {0.75, 4.5}}));
    EXPECT_TRUE(collect(kernels, discs, {{0, 4}}, {20.0, 0.0, 1.0, NO_BODY}) == (Collected{{}, {}}));
  }
}

/// Random discs, some of which touch the circle.
Discs anyDiscs(KeyedRandom& random, const Circle& circle) {
  Discs discs(random.below(40));
  for (std::size_t i = 0; i < discs.xs.size(); ++i) {
    discs.radii[i] = random.uniform(0.0, 0.6);
    discs.xs[i] = random.uniform(-6.0, 6.0);
    discs.ys[i] = random.below(4) == 0 ? circle.y : random.uniform(-6.0, 6.0);
    if (random.below(4) == 0) discs.xs[i] = circle.x + circle.radius + discs.radii[i];
    discs.bodies[i] = random.below(20);
    if (i < discs.size()) continue;
    for (auto* list : {&discs.xs, &discs.ys, &discs.radii}) (*list)[i] = random.below(2) == 0 ? NOT_A_NUMBER : circle.x;
  }
  return discs;
}

TEST(CollectNearby, IsEqualOnEveryTarget) {
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Circle circle{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-0.5, 5.0),
                        random.below(2) == 0 ? NO_BODY : random.below(20)};
    const Discs discs = anyDiscs(random, circle);
    std::vector<DiscRange> ranges;
    for (std::uint32_t begin = 0; begin < discs.size();) {
      const std::uint32_t end = begin + random.below(static_cast<std::uint32_t>(discs.size()) - begin + 1);
      ranges.push_back({begin, end});
      begin = end + random.below(3);
    }
    const Collected expected = collect(REFERENCE, discs, ranges, circle);
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_TRUE(collect(kernels, discs, ranges, circle) == expected) << kernels.target << ", seed " << seed;
    }
  }
}

TEST(IsAnyNearby, ComparesDistancesToRims) {
  Discs discs(2);
  discs.xs = {3.0, 1.0};
  discs.ys = {4.0, 0.0};
  discs.radii = {0.5, 0.25};
  discs.bodies = {7, 8};
  for (auto* list : {&discs.xs, &discs.ys, &discs.radii}) list->resize(2 + DiscArrays::PADDING);  // at the centre
  discs.bodies.resize(2 + DiscArrays::PADDING, 9);
  for (const Kernels& kernels : availableKernels()) {
    SCOPED_TRACE(kernels.target);
    const auto is_any = [&](DiscRange range, double radius, std::uint32_t except) {
      return kernels.is_any_nearby(discs.arrays(), range, {0.0, 0.0, radius, except});
    };
    EXPECT_TRUE(is_any({0, 2}, 0.75, NO_BODY));
    EXPECT_FALSE(is_any({0, 2}, 0.7, NO_BODY));
    EXPECT_FALSE(is_any({0, 2}, 4.0, 8));
    EXPECT_TRUE(is_any({0, 1}, 4.5, 8));
    EXPECT_FALSE(is_any({1, 1}, 9.0, NO_BODY));
    discs.xs[1] = 0.0;
    EXPECT_TRUE(is_any({1, 2}, -0.25, NO_BODY));
    EXPECT_FALSE(is_any({1, 2}, -0.5, NO_BODY));  // the sum of both radii is negative
    discs.xs[1] = 1.0;
  }
}

TEST(IsAnyNearby, IsEqualOnEveryTarget) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 5000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Circle circle{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(-0.5, 2.0),
                        random.below(2) == 0 ? NO_BODY : random.below(20)};
    const Discs discs = anyDiscs(random, circle);
    const std::uint32_t begin = random.below(static_cast<std::uint32_t>(discs.size()) + 1);
    const DiscRange range{begin, begin + random.below(static_cast<std::uint32_t>(discs.size()) - begin + 1)};
    const bool expected = REFERENCE.is_any_nearby(discs.arrays(), range, circle);
    found += expected ? 1 : 0;
    for (const Kernels& kernels : availableKernels()) {
      ASSERT_EQ(kernels.is_any_nearby(discs.arrays(), range, circle), expected) << kernels.target << ", seed " << seed;
    }
  }
  EXPECT_GT(found, 500U);
  EXPECT_LT(found, 4500U);
}

}  // namespace
}  // namespace crowd::simd::nearby_discs_test
