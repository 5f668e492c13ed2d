#include "ranks/floor_strips.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/thread_ranks.h"

namespace crowd::floor_strips_test {
namespace {

/// Places at distances of 1 m along y.
std::vector<Vector2> rowAlongY(int count) {
  std::vector<Vector2> places;
  for (int i = 0; i < count; ++i) places.emplace_back(i % 2, i);
  return places;
}

std::vector<int> countsOf(const FloorStrips& strips, const std::vector<Vector2>& places) {
  std::vector<int> counts(strips.count());
  for (const Vector2& place : places) ++counts[strips.stripOf(place)];
  return counts;
}

TEST(FloorStrips, DivideTheLongerSideIntoEqualParts) {
  const std::vector<Vector2> places = rowAlongY(100);
  EXPECT_EQ(countsOf(FloorStrips(places, 4), places), (std::vector<int>{25, 25, 25, 25}));
  EXPECT_EQ(countsOf(FloorStrips(places, 1), places), (std::vector<int>{100}));
}

TEST(FloorStrips, MeasureDistances) {
  const FloorStrips strips(rowAlongY(100), 4);
  const Vector2 place(0.0, 10.0);
  EXPECT_EQ(strips.stripOf(place), 0);
  EXPECT_EQ(strips.distanceTo(0, place), 0.0);
  EXPECT_NEAR(strips.distanceTo(1, place), 15.0, 1.0);
  EXPECT_NEAR(strips.distanceTo(2, place), 40.0, 1.0);
  EXPECT_EQ(strips.distanceTo(3, {0.0, 1e9}), 0.0) << "the outer strips have no end";
  EXPECT_EQ(strips.stripsWithin(5.0, place), (std::pair<int, int>(0, 0)));
  EXPECT_EQ(strips.stripsWithin(45.0, place), (std::pair<int, int>(0, 2)));
}

TEST(FloorStrips, MayBeEmpty) {
  const std::vector<Vector2> same(7, Vector2(2.0, 3.0));
  const FloorStrips strips(same, 3);
  EXPECT_EQ(countsOf(strips, same)[strips.stripOf(same.front())], 7);
  EXPECT_EQ(FloorStrips({}, 3).count(), 3);
}

TEST(FloorStrips, AreBalancedByAllRanks) {
  ThreadRanks(2).run([](Communicator& communicator) {
    FloorStrips strips(rowAlongY(100), 2);
    // Rank 0 has places from 0 to 99, rank 1 has 100 more between 0 and 10.
    std::vector<Vector2> places = rowAlongY(100);
    if (communicator.rank() == 1) {
      for (Vector2& place : places) place *= 0.1;
    }
    strips.balance(places, communicator);
    std::vector<std::uint64_t> below = {static_cast<std::uint64_t>(countsOf(strips, places)[0])};
    communicator.sum(below);
    EXPECT_NEAR(static_cast<double>(below.front()), 100.0, 2.0);
  });
}

}  // namespace
}  // namespace crowd::floor_strips_test
