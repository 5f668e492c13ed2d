#include "geometry/ray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/wall_index.h"
#include "support/seeds.h"

namespace crowd::ray_test {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();
const Ray AHEAD{{0.0, 0.0}, {1.0, 0.0}};

TEST(Ray, HitsTheRimOfADisc) {
  EXPECT_EQ(distanceAlong(AHEAD, {2.0, 0.0}, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(distanceAlong(AHEAD, {2.0, 0.3}, 0.5), 1.6);
  EXPECT_DOUBLE_EQ(distanceAlong(AHEAD, {2.0, 0.5}, 0.5), 2.0);  // touches it
  EXPECT_EQ(distanceAlong(AHEAD, {2.0, 0.51}, 0.5), INFINITE);
  EXPECT_EQ(distanceAlong(AHEAD, {-2.0, 0.0}, 0.5), INFINITE);
  EXPECT_EQ(distanceAlong(AHEAD, {0.3, 0.1}, 0.5), 0.0);  // from within
}

TEST(Ray, HitsASegmentAndItsEnds) {
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{3.0, -1.0}, {3.0, 1.0}}), 3.0);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{3.0, 1.0}, {3.0, -1.0}}), 3.0);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{3.0, 0.0}, {3.0, 1.0}}), 3.0);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{2.0, -2.0}, {6.0, 2.0}}), 4.0);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{3.0, 0.001}, {3.0, 1.0}}), INFINITE);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{-3.0, -1.0}, {-3.0, 1.0}}), INFINITE);
}

TEST(Ray, HitsTheNearerEndOfASegmentAlongIt) {
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{5.0, 0.0}, {2.0, 0.0}}), 2.0);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{-1.0, 0.0}, {2.0, 0.0}}), 0.0);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{-5.0, 0.0}, {-2.0, 0.0}}), INFINITE);
  EXPECT_EQ(distanceAlong(AHEAD, Segment{{2.0, 0.1}, {5.0, 0.1}}), INFINITE);  // beside it
}

TEST(WallIndexRay, AnEmptyIndexIsNotHit) {
  EXPECT_EQ(WallIndex().firstHit(AHEAD, INFINITE), INFINITE);
  EXPECT_EQ(WallIndex().firstHit(AHEAD, 7.0), 7.0);
}

TEST(WallIndexRay, FindsWallsFromOutsideTheGridAndUpToTheLimit) {
  std::vector<Segment> walls;
  for (int i = 0; i < 20; ++i) walls.push_back({{10.0, 1.0 * i}, {10.0, 1.0 * i + 1.0}});
  const WallIndex index(walls);
  EXPECT_EQ(index.firstHit({{-90.0, 5.5}, {1.0, 0.0}}, INFINITE), 100.0);
  EXPECT_EQ(index.firstHit({{-90.0, 5.0}, {1.0, 0.0}}, INFINITE), 100.0);  // where two walls meet
  EXPECT_EQ(index.firstHit({{-90.0, 5.5}, {1.0, 0.0}}, 99.0), 99.0);
  EXPECT_EQ(index.firstHit({{-90.0, 5.5}, {-1.0, 0.0}}, INFINITE), INFINITE);
  EXPECT_EQ(index.firstHit({{-90.0, 25.0}, {1.0, 0.0}}, INFINITE), INFINITE);
  EXPECT_EQ(index.firstHit({{10.0, -5.0}, {0.0, 1.0}}, INFINITE), 5.0);  // along them
}

/// A coordinate [m]; on whole numbers, where cells of the index begin, if `on_cells`.
double coordinate(KeyedRandom& random, bool on_cells) {
  const double x = random.uniform(-15.0, 15.0);
  return on_cells ? std::round(x) : x;
}

TEST(WallIndexRay, EqualsTheMinimumOverAllWalls) {
  forSeeds(200, KeyedRandom::PLACEMENT, [](std::uint64_t /*seed*/, KeyedRandom& random) {
    const bool on_cells = random.below(2) == 0;
    const auto point = [&] {
      const double x = coordinate(random, on_cells);
      return Vector2(x, coordinate(random, on_cells));
    };
    std::vector<Segment> walls;
    for (std::uint32_t i = random.below(60); i > 0; --i) {
      const Vector2 from = point();
      walls.push_back({from, random.below(2) == 0 ? point() : Vector2(from + Vector2(0.0, random.uniform(0.1, 3.0)))});
    }
    const WallIndex index(walls, random.below(2) == 0 ? 0.0 : 1.2);
    for (int i = 0; i < 200; ++i) {
      const double heading = on_cells ? 0.25 * PI * random.below(8) : random.uniform(-PI, PI);
      const Ray ray{2.0 * point(), unitVector(heading)};
      const double limit = random.below(2) == 0 ? INFINITE : random.uniform(0.0, 20.0);
      double expected = limit;
      for (const Segment& wall : walls) expected = std::min(expected, distanceAlong(ray, wall));
      ASSERT_EQ(index.firstHit(ray, limit), expected);
    }
  });
}

}  // namespace
}  // namespace crowd::ray_test
