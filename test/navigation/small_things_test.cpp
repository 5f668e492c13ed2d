#include "navigation/small_things.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>

#include "support/floors.h"
#include "support/seeds.h"

namespace crowd::small_things_test {
namespace {

/// Number of walls that are left.
std::size_t wallsLeft(const FloorPlan& floor) { return withoutSmallThings(floor).walls.size(); }

void append(const FloorPlan& thing, FloorPlan& floor) {
  floor.walls.insert(floor.walls.end(), thing.walls.begin(), thing.walls.end());
}

TEST(SmallThings, ATableLegIsLeftOut) { EXPECT_EQ(wallsLeft(floors::room({3.0, 3.0}, {3.1, 3.1})), 0U); }

/// Diagonals of 0.79 m and 0.8 m (0.48 m by 0.64 m).
TEST(SmallThings, TheDiagonalDecides) {
  EXPECT_EQ(wallsLeft(floors::room({0.0, 0.0}, {0.474, 0.632})), 0U);
  EXPECT_EQ(wallsLeft(floors::room({0.0, 0.0}, {0.48, 0.641})), 4U);
}

TEST(SmallThings, AWallOfShortPiecesIsOneThing) {
  FloorPlan floor;
  for (int i = 0; i < 10; ++i) floor.walls.push_back({{0.1 * i, 0.0}, {0.1 * (i + 1), 0.0}});
  EXPECT_EQ(wallsLeft(floor), 10U);
  floor.walls.erase(floor.walls.begin() + 5);  // two pieces of 0.5 m and 0.4 m that do not touch
  EXPECT_EQ(wallsLeft(floor), 0U);
}

/// The pieces at both ends are listed first, so that they are joined only by a wall that comes later.
TEST(SmallThings, ThingsAreJoinedByALaterWall) {
  FloorPlan floor;
  floor.walls = {{{0.0, 0.0}, {0.3, 0.0}}, {{0.6, 0.0}, {0.9, 0.0}}};
  EXPECT_EQ(wallsLeft(floor), 0U);
  floor.walls.push_back({{0.6, 0.0}, {0.3, 0.0}});
  EXPECT_EQ(wallsLeft(floor), 3U);
}

TEST(SmallThings, WallsThatCrossWithoutACommonEndAreTwoThings) {
  FloorPlan floor;
  floor.walls = {{{-0.35, 0.0}, {0.35, 0.0}}, {{0.0, -1.0}, {0.0, 1.0}}};
  const FloorPlan large = withoutSmallThings(floor);
  ASSERT_EQ(large.walls.size(), 1U);
  EXPECT_EQ(large.walls[0].to, Vector2(0.0, 1.0));
}

TEST(SmallThings, OrderObstaclesAndBoundsStay) {
  FloorPlan floor = floors::room({0.0, 0.0}, {5.0, 4.0});
  append(floors::room({1.0, 1.0}, {1.1, 1.1}), floor);
  floor.walls.push_back({{2.0, 0.0}, {2.0, 2.0}});
  floor.obstacles = {{{3.0, 3.0}, 0.1}};
  floor.bounds = FloorPlan::Bounds{{-1.0, -1.0}, {6.0, 5.0}};
  const FloorPlan large = withoutSmallThings(floor);
  ASSERT_EQ(large.walls.size(), 5U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(large.walls[i].from, floor.walls[i].from);
  EXPECT_EQ(large.walls[4].from, Vector2(2.0, 0.0));
  ASSERT_EQ(large.obstacles.size(), 1U);
  EXPECT_EQ(large.obstacles[0].radius, 0.1);
  ASSERT_TRUE(large.bounds);
  EXPECT_EQ(large.bounds->high, Vector2(6.0, 5.0));
  EXPECT_EQ(wallsLeft(FloorPlan()), 0U);
}

/// Square boxes of side 0.1 m to 1.1 m apart from each other, with their walls shuffled: a box is left out if and only
/// if its side is below 0.8 m / sqrt(2) = 0.5657 m.
TEST(SmallThings, EachThingIsJudgedByItself) {
  forSeeds(50, KeyedRandom::CONTENT, [](std::uint64_t /*seed*/, KeyedRandom& random) {
    FloorPlan floor;
    std::size_t expected = 0;
    for (int i = 0; i < 20; ++i) {
      const Vector2 corner(2.0 * i, random.uniform(0.0, 5.0));
      const double side = random.uniform(0.1, 1.1);
      append(floors::room(corner, corner + Vector2(side, side)), floor);
      expected += side >= 0.5657 ? 4 : 0;
      if (side >= 0.5656 && side < 0.5658) return;  // too close to decide by rounded numbers
    }
    for (auto left = static_cast<std::uint32_t>(floor.walls.size()); left > 1; --left) {
      std::swap(floor.walls[left - 1], floor.walls[random.below(left)]);
    }
    EXPECT_EQ(wallsLeft(floor), expected);
  });
}

}  // namespace
}  // namespace crowd::small_things_test
