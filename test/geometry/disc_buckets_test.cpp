#include "geometry/disc_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/seeds.h"

namespace crowd::disc_buckets_test {
namespace {

/// The first of all discs whose rim is within the distance of a point.
std::size_t firstOfAll(const DiscBuckets& discs, const Vector2& point, double distance) {
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if ((discs[i].centre - point).norm() <= distance + discs[i].radius) return i;
  }
  return DiscBuckets::NONE;
}

Vector2 draw(KeyedRandom& random, double half_width) {
  const double x = random.uniform(-half_width, half_width);
  return {x, random.uniform(-half_width, half_width)};
}

TEST(DiscBuckets, FindTheFirstDiscAsAListDoes) {
  std::size_t found = 0;
  forSeeds(20, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& random) {
    DiscBuckets discs;
    const double half_width = seed % 4 == 0 ? 1e7 : 30.0;
    const std::uint32_t count = 1 + random.below(400);
    for (std::uint32_t i = 0; i < count; ++i) {
      // Every hundredth one is large.
      discs.add(draw(random, half_width), random.below(100) == 0 ? random.uniform(1.0, 9.0) : random.uniform(0.0, 1.0));
      const Vector2 point =
          random.below(3) == 0 ? Vector2(discs[i / 2].centre + draw(random, 3.0)) : draw(random, half_width);
      const double distance = random.uniform(-0.1, random.below(10) == 0 ? 50.0 : 1.0);
      const auto matches = [&](std::size_t number) {
        return (discs[number].centre - point).norm() <= distance + discs[number].radius;
      };
      const std::size_t expected = firstOfAll(discs, point, distance);
      ASSERT_EQ(discs.findFirst(point, distance, matches), expected) << i;
      EXPECT_EQ(discs.isAnyNear(point, distance, matches), expected != DiscBuckets::NONE);
      found += expected != DiscBuckets::NONE ? 1 : 0;
    }
  });
  EXPECT_GT(found, 500U);
}

}  // namespace
}  // namespace crowd::disc_buckets_test
