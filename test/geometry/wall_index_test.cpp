#include "geometry/wall_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "maps/map_walls.h"
#include "support/maps.h"
#include "support/scenes.h"
#include "support/seeds.h"

namespace crowd::wall_index_test {
namespace {

using Found = std::vector<std::uint32_t>;
using Walls = std::vector<Segment>;

constexpr double INFINITE = std::numeric_limits<double>::infinity();

Found find(const WallIndex& index, const Vector2& point, double distance) {
  Found found;
  index.findNear(point, distance, found);
  return found;
}

/// A wall from (0, 0) to (4, 0), either alone or with walls that make the index a grid, 100 m away.
std::vector<WallIndex> indicesOfOneNearWall() {
  const Segment near{{0.0, 0.0}, {4.0, 0.0}};
  Walls walls = {near};
  for (int i = 0; i < 20; ++i) walls.push_back({{100.0, 1.0 * i}, {100.0, 1.0 * i + 1.0}});
  return {WallIndex({near}), WallIndex(walls)};
}

TEST(WallIndex, EmptyIndexFindsNothing) {
  const WallIndex index;
  EXPECT_TRUE(find(index, {0.0, 0.0}, 1e9).empty());
  EXPECT_FALSE(index.isAnyWithin({0.0, 0.0}, 1e9));
  EXPECT_EQ(index.nearestDistance({0.0, 0.0}, 7.0), 7.0);
  EXPECT_EQ(index.nearestDistance({0.0, 0.0}, INFINITE), INFINITE);
  EXPECT_TRUE(index.isClear({0.0, 0.0}, {1e6, 0.0}, 10.0));
}

TEST(WallIndex, FindsWallsWithinADistance) {
  for (const WallIndex& index : indicesOfOneNearWall()) {
    SCOPED_TRACE(index.walls().size());
    EXPECT_EQ(find(index, {2.0, 0.5}, 0.5), Found{0});
    EXPECT_TRUE(find(index, {2.0, 0.5}, 0.499).empty());
    EXPECT_EQ(find(index, {7.0, 4.0}, 5.0), Found{0});  // beyond its end
    EXPECT_TRUE(index.isAnyWithin({2.0, -0.5}, 0.5));
    EXPECT_TRUE(index.isAnyWithin({2.0, 0.0}, 0.0));
    EXPECT_FALSE(index.isAnyWithin({2.0, 0.0}, -0.1));
    EXPECT_TRUE(find(index, {2.0, 0.0}, -0.1).empty());
    EXPECT_EQ(index.nearestDistance({7.0, 4.0}, INFINITE), 5.0);
    EXPECT_EQ(index.nearestDistance({-3.0, -4.0}, 6.0), 5.0);
    EXPECT_EQ(index.nearestDistance({-3.0, -4.0}, 4.0), 4.0);
    EXPECT_EQ(index.nearestDistance({2.0, 0.0}, 0.0), 0.0);
  }
}

TEST(WallIndex, AppendsFoundWalls) {
  for (const WallIndex& index : indicesOfOneNearWall()) {
    Found found = {9, 3, 3};
    index.findNear({2.0, 0.5}, 1.0, found);
    EXPECT_EQ(found, (Found{9, 3, 3, 0}));
  }
}

TEST(WallIndex, ChecksThePathOfADisc) {
  for (const WallIndex& index : indicesOfOneNearWall()) {
    SCOPED_TRACE(index.walls().size());
    EXPECT_FALSE(index.isClear({2.0, -3.0}, {2.0, 3.0}, 0.25));   // through it
    EXPECT_TRUE(index.isClear({4.5, -3.0}, {4.5, 3.0}, 0.25));    // beside it
    EXPECT_FALSE(index.isClear({4.5, -3.0}, {4.5, 3.0}, 0.501));  // over its end
    EXPECT_TRUE(index.isClear({-1.0, 0.5}, {5.0, 0.5}, 0.5));     // along it, touching
    EXPECT_FALSE(index.isClear({-1.0, 0.5}, {5.0, 0.5}, 0.501));
    EXPECT_TRUE(index.isClear({2.0, 3.0}, {2.0, 0.5}, 0.5));  // up to it
    EXPECT_FALSE(index.isClear({2.0, 3.0}, {2.0, 0.5}, 0.501));
    EXPECT_FALSE(index.isClear({2.0, 0.25}, {2.0, 0.25}, 0.5));  // standing
    EXPECT_TRUE(index.isClear({2.0, 0.5}, {2.0, 0.5}, 0.5));
  }
}

TEST(WallIndex, ChecksThePathOfAPoint) {
  for (const WallIndex& index : indicesOfOneNearWall()) {
    SCOPED_TRACE(index.walls().size());
    EXPECT_FALSE(index.isClear({2.0, -3.0}, {2.0, 3.0}, 0.0));
    EXPECT_FALSE(index.isClear({4.0, -3.0}, {4.0, 3.0}, 0.0));  // touches its end
    EXPECT_FALSE(index.isClear({2.0, 3.0}, {2.0, 0.0}, 0.0));   // ends on it
    EXPECT_FALSE(index.isClear({-1.0, 0.0}, {1.0, 0.0}, 0.0));  // along it
    EXPECT_TRUE(index.isClear({-2.0, 0.0}, {-1.0, 0.0}, 0.0));  // on its line
    EXPECT_TRUE(index.isClear({2.0, 3.0}, {2.0, 0.001}, 0.0));
  }
}

TEST(WallIndex, SearchesExtremeExtents) {
  Walls walls(20, {{0.0, 0.0}, {1.0, 0.0}});
  walls.push_back({{-1.5e308, 0.0}, {-1.5e308, 1.0}});
  walls.push_back({{1.5e308, 5.0}, {1.5e308, 6.0}});
  const WallIndex index(walls);
  EXPECT_EQ(find(index, {0.5, 1.0}, 1.0).size(), 20U);
  EXPECT_FALSE(index.isAnyWithin({0.5, 1.0}, 0.9));
  EXPECT_EQ(index.nearestDistance({0.5, 1.0}, INFINITE), 1.0);
}

/// Short walls, some in clusters, long ones in all directions and along the axes, points, and some very far away.
Walls randomWalls(KeyedRandom& random, double extent) {
  Walls walls(random.below(random.below(3) == 0 ? 12 : 300));
  Vector2 cluster = Vector2::Zero();
  for (Segment& wall : walls) {
    if (random.below(20) == 0) cluster = scenes::randomPoint(random, extent);
    const std::uint32_t kind = random.below(12);
    wall.from = kind < 5 ? Vector2(cluster + scenes::randomPoint(random, 1.0)) : scenes::randomPoint(random, extent);
    wall.to = kind < 8 ? Vector2(wall.from + scenes::randomPoint(random, 1.0)) : scenes::randomPoint(random, extent);
    if (kind == 8) wall.to.x() = wall.from.x();
    if (kind == 9) wall.to.y() = wall.from.y();
    if (kind == 10) wall.to = wall.from;
    if (kind == 11 && random.below(5) == 0) wall.from *= 100.0;
  }
  return walls;
}

/// Calls check(walls, extent, random) for walls of many kinds: random ones and those of maps.
template <typename Check>
void checkManyPlaces(const Check& check) {
  forSeeds(60, KeyedRandom::PLACEMENT, [&](std::uint64_t seed, KeyedRandom& random) {
    const double extent = random.uniform(1.0, 50.0);
    if (seed % 4 != 0) {
      check(randomWalls(random, extent), extent, random);
    } else {
      OccupancyMap map = maps::random(random);
      map.origin.position = {0.0, 0.0};
      check(traceWalls(map), map.resolution * map.width, random);
    }
  });
}

/// Points anywhere, and near the ends of walls.
Vector2 pointAmong(const Walls& walls, double extent, KeyedRandom& random) {
  if (walls.empty() || random.below(3) == 0) return scenes::randomPoint(random, 2.0 * extent);
  const Segment& wall = walls[random.below(static_cast<std::uint32_t>(walls.size()))];
  return wall.from + scenes::randomPoint(random, random.below(2) == 0 ? 2.0 : 1e-3);
}

TEST(WallIndex, FindsTheSameAsASearchOfAllWalls) {
  std::size_t found_walls = 0;
  checkManyPlaces([&](const Walls& walls, double extent, KeyedRandom& random) {
    const WallIndex index(walls, random.uniform(0.1, 4.0));
    for (int i = 0; i < 50; ++i) {
      const Vector2 point = pointAmong(walls, extent, random);
      const double distance = random.uniform(0.0, random.below(2) == 0 ? 1.0 : extent);
      Found expected;
      double nearest = INFINITE;
      for (std::uint32_t w = 0; w < walls.size(); ++w) {
        nearest = std::min(nearest, distanceTo(walls[w], point));
        if (distanceTo(walls[w], point) <= distance) expected.push_back(w);
      }
      EXPECT_EQ(find(index, point, distance), expected);
      EXPECT_EQ(index.isAnyWithin(point, distance), !expected.empty());
      EXPECT_EQ(index.nearestDistance(point, distance), std::min(distance, nearest));
      EXPECT_EQ(index.nearestDistance(point, INFINITE), nearest);
      found_walls += expected.size();
    }
  });
  EXPECT_GT(found_walls, 10000U);  // or there was nothing to compare
}

/// The smallest distance between a path and a wall, too large by at most half of `step` [m].
double sampledDistance(const Segment& path, const WallIndex& index, double step) {
  const double length = (path.to - path.from).norm();
  const int steps = static_cast<int>(length / step) + 1;
  double nearest = INFINITE;
  for (int i = 0; i <= steps; ++i) {
    const Vector2 point = path.from + (path.to - path.from) * (static_cast<double>(i) / steps);
    nearest = std::min(nearest, index.nearestDistance(point, INFINITE));
  }
  return nearest;
}

TEST(WallIndex, PathIsClearIfItIsClearOfEachWall) {
  int clear = 0;
  int blocked = 0;
  checkManyPlaces([&](const Walls& walls, double extent, KeyedRandom& random) {
    const WallIndex index(walls, random.uniform(0.1, 4.0));
    std::vector<WallIndex> each;
    for (const Segment& wall : walls) each.emplace_back(Walls{wall});
    for (int i = 0; i < 30; ++i) {
      const Vector2 from = pointAmong(walls, extent, random);
      const bool is_long = random.below(3) == 0;
      const Vector2 to = is_long ? pointAmong(walls, extent, random) : from + scenes::randomPoint(random, 1.0);
      const double radius = random.below(4) == 0 ? 0.0 : random.uniform(0.0, 0.5);
      const bool is_clear =
          std::all_of(each.begin(), each.end(), [&](const WallIndex& wall) { return wall.isClear(from, to, radius); });
      EXPECT_EQ(index.isClear(from, to, radius), is_clear);
      ++(is_clear ? clear : blocked);
    }
  });
  EXPECT_GT(clear, 100);
  EXPECT_GT(blocked, 100);
}

TEST(WallIndex, PathIsClearIfAllItsPointsAre) {
  constexpr double STEP = 0.01;
  int clear = 0;
  int blocked = 0;
  checkManyPlaces([&](const Walls& walls, double extent, KeyedRandom& random) {
    const WallIndex index(walls);
    for (int i = 0; i < 30; ++i) {
      const Vector2 from = pointAmong(walls, extent, random);
      const Vector2 to = from + scenes::randomPoint(random, 2.0);
      const double radius = random.uniform(0.0, 0.5);
      const double sampled = sampledDistance({from, to}, index, STEP);
      const bool is_clear = index.isClear(from, to, radius);
      EXPECT_TRUE(is_clear ? sampled >= radius - 1e-9 : sampled <= radius + STEP) << sampled << " and " << radius;
      ++(is_clear ? clear : blocked);
    }
  });
  EXPECT_GT(clear, 100);
  EXPECT_GT(blocked, 100);
}

TEST(WallIndex, MemoryIsLimited) {
  KeyedRandom random(1, KeyedRandom::PLACEMENT, {});
  Walls walls(1000);
  for (Segment& wall : walls) wall = {scenes::randomPoint(random, 5000.0), scenes::randomPoint(random, 5000.0)};
  const WallIndex index(walls);
  EXPECT_LT(index.memory(), (std::size_t{1} << 22U) + 1000 * (sizeof(Segment) + 4 * 64) + 4 * 65536 + 1000);
  EXPECT_TRUE(index.isAnyWithin(walls[500].from, 0.0));
}

}  // namespace
}  // namespace crowd::wall_index_test
