#include "maps/free_space.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "maps/map_walls.h"
#include "support/floors.h"
#include "support/maps.h"

namespace crowd::free_space_test {
namespace {

FloorPlan floorOf(const OccupancyMap& map) {
  FloorPlan floor;
  floor.walls = traceWalls(map);
  return floor;
}

FreeSpace freeSpace(const OccupancyMap& map, double radius) { return {map, floorOf(map), radius}; }

/// Two rooms of 3 m x 2 m and a niche of 1 m x 1 m.
OccupancyMap twoRooms() { return maps::drawn({"#########", "#...#...#", "#...#...#", "##.######", "#########"}); }

TEST(FreeSpace, RoomsAreComponents) {
  const OccupancyMap map = twoRooms();
  const FreeSpace space = freeSpace(map, 0.2);
  EXPECT_FALSE(space.empty());
  EXPECT_NE(space.component({2.5, 3.0}), FreeSpace::NONE);
  EXPECT_NE(space.component({6.5, 3.0}), FreeSpace::NONE);
  EXPECT_NE(space.component({2.5, 3.0}), space.component({6.5, 3.0}));
  EXPECT_EQ(space.component({2.5, 3.0}), space.component({2.5, 1.5}));  // the niche
  EXPECT_EQ(space.component({4.5, 3.0}), FreeSpace::NONE);              // in the wall
  EXPECT_EQ(space.component({-50.0, 3.0}), FreeSpace::NONE);            // beside the map
}

TEST(FreeSpace, ANicheThatIsTooNarrowIsNotFree) {
  const FreeSpace space = freeSpace(twoRooms(), 0.6);
  EXPECT_NE(space.component({2.5, 3.0}), FreeSpace::NONE);
  EXPECT_EQ(space.component({2.5, 1.5}), FreeSpace::NONE);
}

TEST(FreeSpace, WithoutSpaceItIsEmpty) {
  EXPECT_TRUE(freeSpace(twoRooms(), 1.5).empty());
  EXPECT_TRUE(freeSpace(maps::drawn({"##", "?#"}), 0.1).empty());
}

TEST(FreeSpace, WallsAndObstaclesOnTheMapCount) {
  const OccupancyMap map = maps::drawn({"......", "......", "......", "......"});
  FloorPlan floor = floorOf(map);
  floor.walls.push_back({{3.0, 0.0}, {3.0, 4.0}});
  floor.obstacles = {{{1.0, 2.0}, 0.3}};
  const FreeSpace space(map, floor, 0.3);
  EXPECT_NE(space.component({2.2, 3.0}), space.component({4.0, 3.0}));
  EXPECT_EQ(space.component({1.0, 2.0}), FreeSpace::NONE);
  EXPECT_EQ(space.component({3.0, 2.0}), FreeSpace::NONE);
}

TEST(FreeSpace, DrawnPlacesFitAndAreEverywhere) {
  for (const double yaw : {0.0, 0.4}) {
    const OccupancyMap map =
        maps::drawn({"#########", "#...#...#", "#...#...#", "##.######", "#########"}, 0.5, {{10.0, -3.0}, yaw});
    const FloorPlan floor = floorOf(map);
    const FreeSpace space(map, floor, 0.2);
    std::set<std::uint32_t> components;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
      KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
      const Vector2 place = space.draw(random);
      // Half a step of the grid beside a place where the agent fits, in both directions.
      ASSERT_GE(floors::clearanceAt(floor, place), 0.2 - 0.36 * map.resolution) << "seed " << seed;
      ASSERT_TRUE(map.isFree(CellFrame(map).cellAt(place))) << "seed " << seed;
      components.insert(space.component(place));
    }
    EXPECT_EQ(components.size(), 2U);
    EXPECT_EQ(components.count(FreeSpace::NONE), 0U);
  }
}

/// A hall of 12 m x 9 m and a cell of 1 m x 1 m.
TEST(FreeSpace, PlacesAreNotDrawnFromPockets) {
  std::vector<std::string> rows(11, "#............###");
  rows.front() = rows.back() = std::string(16, '#');
  rows[5][14] = '.';
  const FreeSpace space = freeSpace(maps::drawn(rows), 0.2);
  EXPECT_NE(space.component({14.5, 5.5}), FreeSpace::NONE);
  for (std::uint64_t seed = 0; seed < 10000; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    ASSERT_LT(space.draw(random).x(), 13.0) << "seed " << seed;
  }
}

TEST(FreeSpace, TheSameNumbersGiveTheSamePlace) {
  const FreeSpace space = freeSpace(twoRooms(), 0.3);
  KeyedRandom first(7, KeyedRandom::PLACEMENT, {1});
  KeyedRandom second(7, KeyedRandom::PLACEMENT, {1});
  for (int i = 0; i < 10; ++i) EXPECT_EQ(space.draw(first), space.draw(second));
}

}  // namespace
}  // namespace crowd::free_space_test
