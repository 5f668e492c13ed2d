#include "geometry/impact.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/scenes.h"

namespace crowd::impact_test {
namespace {

/// A wall across the way, 2 m ahead.
const Segment ACROSS{{2.0, -1.0}, {2.0, 1.0}};

TEST(FirstTouchOfDiscs, ByHand) {
  EXPECT_DOUBLE_EQ(firstTouch(Vector2(3.0, 0.0), {4.0, 0.0}, 1.0, 1.0), 0.5);   // 2 m of gap
  EXPECT_DOUBLE_EQ(firstTouch(Vector2(3.0, 0.6), {4.0, 0.0}, 1.0, 1.0), 0.55);  // when it is 0.8 m ahead
  EXPECT_DOUBLE_EQ(firstTouch(Vector2(0.0, -3.0), {0.0, -2.5}, 1.0, 1.0), 0.8);
  EXPECT_EQ(firstTouch(Vector2(0.0, -3.0), {0.0, -2.0}, 1.0, 1.0), NO_IMPACT);  // just up to it
}

TEST(FirstTouchOfDiscs, IsLimitedToTheRestOfTheTick) {
  EXPECT_EQ(firstTouch(Vector2(3.0, 0.0), {4.0, 0.0}, 1.0, 0.49), NO_IMPACT);
  EXPECT_DOUBLE_EQ(firstTouch(Vector2(3.0, 0.0), {4.0, 0.0}, 1.0, 0.51), 0.5);
}

TEST(FirstTouchOfDiscs, PassingOrGrazingIsNoTouch) {
  EXPECT_EQ(firstTouch(Vector2(3.0, 1.1), {9.0, 0.0}, 1.0, 1.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(Vector2(3.0, 1.0), {9.0, 0.0}, 1.0, 1.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(Vector2(3.0, 1.0 - 0.5e-10), {9.0, 0.0}, 1.0, 1.0), NO_IMPACT);
  EXPECT_NEAR(firstTouch(Vector2(3.0, 1.0 - 2e-10), {9.0, 0.0}, 1.0, 1.0), 1.0 / 3.0, 1e-4);
}

TEST(FirstTouchOfDiscs, StandingOrMovingAwayIsNoTouch) {
  EXPECT_EQ(firstTouch(Vector2(3.0, 0.0), {0.0, 0.0}, 1.0, 1.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(Vector2(3.0, 0.0), {-4.0, 0.0}, 1.0, 1.0), NO_IMPACT);
}

TEST(FirstTouchOfDiscs, TouchingDiscsMaySeparateButNotApproach) {
  EXPECT_EQ(firstTouch(Vector2(1.0, 0.0), {1e-3, 0.0}, 1.0, 1.0), 0.0);
  EXPECT_EQ(firstTouch(Vector2(0.7, 0.0), {1e-3, 0.0}, 1.0, 1.0), 0.0);  // overlaps by 0.3 m
  EXPECT_EQ(firstTouch(Vector2(1.0, 0.0), {0.0, 1.0}, 1.0, 1.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(Vector2(0.7, 0.0), {0.0, 1.0}, 1.0, 1.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(Vector2(0.7, 0.0), {-1.0, 0.0}, 1.0, 1.0), NO_IMPACT);
}

TEST(FirstTouchOfWalls, OfTheSideByHand) {
  EXPECT_DOUBLE_EQ(firstTouch(ACROSS, {4.0, 0.0}, 0.5, 1.0), 0.375);
  EXPECT_DOUBLE_EQ(firstTouch(Segment{ACROSS.to, ACROSS.from}, {4.0, 1.0}, 0.5, 1.0), 0.375);
  EXPECT_EQ(firstTouch(ACROSS, {4.0, 0.0}, 0.5, 0.37), NO_IMPACT);
  EXPECT_EQ(firstTouch(ACROSS, {-4.0, 0.0}, 0.5, 1.0), NO_IMPACT);
}

TEST(FirstTouchOfWalls, OfTheEndsByHand) {
  const Segment above{{2.0, 0.3}, {2.0, 5.0}};
  EXPECT_DOUBLE_EQ(firstTouch(above, {4.0, 0.0}, 0.5, 1.0), 0.4);  // the end is 0.4 m ahead then
  const Segment along{{2.0, 0.0}, {5.0, 0.0}};
  EXPECT_DOUBLE_EQ(firstTouch(along, {4.0, 0.0}, 0.5, 1.0), 0.375);
  EXPECT_EQ(firstTouch(Segment{{2.0, 0.6}, {2.0, 5.0}}, {4.0, 0.0}, 0.5, 1.0), NO_IMPACT);
}

TEST(FirstTouchOfWalls, WalkingAlongIsNoTouch) {
  const Segment beside{{-1.0, -0.5}, {1.0, -0.5}};
  EXPECT_EQ(firstTouch(beside, {9.0, 0.0}, 0.5, 1.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(beside, 9.0 * unitVector(-1e-16), 0.5, 1.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(beside, {9.0, -0.1}, 0.5, 1.0), 0.0);
}

/// Distance of a wall from the disc's centre after a share of the way.
double distanceAfter(const Segment& wall, const Vector2& way, double time) { return distanceTo(wall, time * way); }

TEST(FirstTouchProperty, OfWallsAgreesWithSampledTimes) {
  constexpr int STEPS = 2000;
  int touches = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Vector2 from = scenes::randomPoint(random, 2.0);
    const Segment wall{from, scenes::randomPoint(random, 2.0)};
    const Vector2 way = scenes::randomPoint(random, 3.0);
    const double reach = random.uniform(0.1, 0.5);
    if (distanceAfter(wall, way, 0.0) < reach) continue;
    const double touch = firstTouch(wall, way, reach, 1.0);
    for (int i = 0; i <= STEPS; ++i) {
      const double time = static_cast<double>(i) / STEPS;
      if (time > touch) break;
      EXPECT_GT(distanceAfter(wall, way, time), reach - 1e-9) << "at " << time;
    }
    if (touch == NO_IMPACT) continue;
    EXPECT_NEAR(distanceAfter(wall, way, touch), reach, 1e-12);
    ++touches;
  }
  EXPECT_GT(touches, 50);
}

}  // namespace
}  // namespace crowd::impact_test
