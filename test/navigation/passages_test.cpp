#include "navigation/passages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "support/floors.h"
#include "support/seeds.h"

namespace crowd::passages_test {
namespace {

constexpr double RADIUS = 0.2;
constexpr double MAX_WIDTH = 1.2;

/// A wall along the y axis with a gap of this width around y = 0, in a room of 10 m by 8 m.
FloorPlan doorPlan(double width) {
  FloorPlan floor;
  floor.walls = {{{0.0, -4.0}, {0.0, -0.5 * width}}, {{0.0, 0.5 * width}, {0.0, 4.0}}, {{-5.0, -4.0}, {5.0, -4.0}},
                 {{5.0, -4.0}, {5.0, 4.0}},          {{5.0, 4.0}, {-5.0, 4.0}},        {{-5.0, 4.0}, {-5.0, -4.0}}};
  return floor;
}

TEST(Passages, ADoorIsAPassageWithTwoMouths) {
  const Passages passages(doorPlan(0.9), RADIUS, MAX_WIDTH);
  ASSERT_EQ(passages.size(), 1U);
  EXPECT_NEAR(passages[0].width, 0.9, 2.0 * Passages::SPACING);
  ASSERT_EQ(passages[0].mouths.size(), 2U);
  const Mouth& left = passages[0].mouths[passages[0].mouths[0].centre.x() < 0.0 ? 0 : 1];
  const Mouth& right = passages[0].mouths[passages[0].mouths[0].centre.x() < 0.0 ? 1 : 0];
  // The passage is the disc of the door's width.
  EXPECT_NEAR(left.centre.x(), -0.4, 0.15);
  EXPECT_NEAR(right.centre.x(), 0.4, 0.15);
  EXPECT_NEAR(left.outward.x(), -1.0, 0.05);
  EXPECT_NEAR(right.outward.x(), 1.0, 0.05);
  EXPECT_EQ(passages.at({0.0, 0.0}), 0);
  EXPECT_EQ(passages.at({1.0, 0.0}), Passages::NONE);
  EXPECT_EQ(passages.at({100.0, 0.0}), Passages::NONE);
}

TEST(Passages, ADoorInAFreeStandingWallHasTwoMouths) {
  FloorPlan floor;
  floor.walls = {{{0.0, -6.0}, {0.0, -0.4}}, {{0.0, 0.4}, {0.0, 6.0}}};
  const Passages passages(floor, RADIUS, MAX_WIDTH);
  ASSERT_EQ(passages.size(), 1U);
  EXPECT_EQ(passages[0].mouths.size(), 2U);
  EXPECT_NEAR(passages[0].width, 0.8, 2.0 * Passages::SPACING);
}

TEST(Passages, WideDoorsAndCornersAreNotPassages) { EXPECT_EQ(Passages(doorPlan(1.5), RADIUS, MAX_WIDTH).size(), 0U); }

TEST(Passages, ADoorNarrowerThanAnAgentIsNotAPassage) {
  EXPECT_EQ(Passages(doorPlan(0.3), RADIUS, MAX_WIDTH).size(), 0U);
}

TEST(Passages, ANarrowCorridorIsOnePassage) {
  FloorPlan floor = doorPlan(1.0);
  floor.walls.push_back({{0.0, -0.5}, {3.0, -0.5}});
  floor.walls.push_back({{0.0, 0.5}, {3.0, 0.5}});
  const Passages passages(floor, RADIUS, MAX_WIDTH);
  ASSERT_EQ(passages.size(), 1U);
  ASSERT_EQ(passages[0].mouths.size(), 2U);
  EXPECT_NEAR((passages[0].mouths[0].centre - passages[0].mouths[1].centre).norm(), 4.0, 0.3);
  EXPECT_EQ(passages.at({1.5, 0.0}), 0);
}

TEST(Passages, GapsBetweenObstaclesArePassages) {
  FloorPlan floor;
  floor.obstacles = {{{0.0, 1.0}, 0.5}, {{0.0, -1.0}, 0.5}};
  const Passages passages(floor, RADIUS, MAX_WIDTH);
  ASSERT_EQ(passages.size(), 1U);
  EXPECT_NEAR(passages[0].width, 1.0, 2.0 * Passages::SPACING);
}

TEST(Passages, AnEmptyFloorHasNoPassage) {
  const Passages passages(FloorPlan{}, RADIUS, MAX_WIDTH);
  EXPECT_EQ(passages.size(), 0U);
  EXPECT_EQ(passages.at({0.0, 0.0}), Passages::NONE);
}

/// Distances are stored for blocks of this side [m].
constexpr double BLOCK = 0.2;

/// The door's disc of radius 0.45 m ends 1.55 m before (2, 0). Discs of throats near the door's line reach a few grid
/// points farther.
TEST(Passages, DistanceFromTheDoor) {
  const Passages passages(doorPlan(0.9), RADIUS, MAX_WIDTH);
  EXPECT_EQ(passages.distanceFrom({0.0, 0.0}), 0.0);
  EXPECT_LE(passages.distanceFrom({2.0, 0.0}), 1.55);
  EXPECT_GE(passages.distanceFrom({2.0, 0.0}), 1.55 - 2.0 * BLOCK - Passages::SPACING);
  EXPECT_EQ(passages.distanceFrom({100.0, 0.0}), 0.0);  // beyond the grid it is not known
}

/// Places at which a grid point of a passage is, in the room of floors::random().
std::vector<Vector2> gridPointsInPassages(const FloorPlan& floor, const Passages& passages) {
  const ClearanceGrid grid(floor, Passages::SPACING, 0.5 * MAX_WIDTH + Passages::SPACING);  // as that of the passages
  std::vector<Vector2> places;
  for (ClearanceGrid::Index point = 0; point < grid.size(); ++point) {
    if (passages.at(grid.place(point)) != Passages::NONE) places.push_back(grid.place(point));
  }
  return places;
}

/// A place belongs to the passage of its nearest grid point: the cell of a grid point reaches half the spacing from it.
double distanceToCell(const Vector2& place, const Vector2& grid_point) {
  const Vector2 aside = (place - grid_point).cwiseAbs() - Vector2::Constant(0.5 * Passages::SPACING);
  return aside.cwiseMax(0.0).norm();
}

TEST(Passages, DistancesAreLowerBounds) {
  std::size_t floors_with_passages = 0;
  double largest = 0.0;
  forSeeds(40, KeyedRandom::CONTENT, [&](std::uint64_t /*seed*/, KeyedRandom& random) {
    const FloorPlan floor = floors::random(random);
    const Passages passages(floor, RADIUS, MAX_WIDTH);
    const std::vector<Vector2> inside = gridPointsInPassages(floor, passages);
    floors_with_passages += inside.empty() ? 0 : 1;
    for (int i = 0; i < 200 && !inside.empty(); ++i) {
      const double x = random.uniform(-2.0, 8.0);
      const Vector2 place(x, random.uniform(-2.0, 7.0));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vector2& grid_point : inside) nearest = std::min(nearest, distanceToCell(place, grid_point));
      const double bound = passages.distanceFrom(place);
      largest = std::max(largest, bound);
      ASSERT_LE(bound, nearest + 1e-9) << place.transpose();
      ASSERT_GE(bound, 0.0);
      // Steps are diagonal, too: a distance is at most sqrt(2) times the steps.
      if (bound == 0.0) continue;
      ASSERT_GE(bound, nearest / std::sqrt(2.0) - 2.0 * BLOCK) << place.transpose();
    }
  });
  EXPECT_GT(floors_with_passages, 20U);
  EXPECT_GT(largest, 2.0);
}

/// The distance is stored up to 255 blocks: it is a bound there, too.
TEST(Passages, LargeDistancesAreBounds) {
  FloorPlan floor = doorPlan(0.9);
  floor.walls.push_back({{60.0, -4.0}, {60.0, 4.0}});
  const Passages passages(floor, RADIUS, MAX_WIDTH);
  for (const double x : {12.0, 13.0, 13.2, 20.0, 59.0}) {
    EXPECT_GT(passages.distanceFrom({x, 0.0}), 11.0) << x;
    EXPECT_LE(passages.distanceFrom({x, 0.0}), x - 0.45 + Passages::SPACING) << x;
  }
}

TEST(Passages, WithoutPassagesNoDistanceIsKnown) {
  const Passages passages(doorPlan(1.5), RADIUS, MAX_WIDTH);
  EXPECT_EQ(passages.size(), 0U);
  EXPECT_EQ(passages.distanceFrom({0.0, 0.0}), 0.0);
}

}  // namespace
}  // namespace crowd::passages_test
