#include "geometry/robot_sweep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "common/random.h"
#include "geometry/impact.h"

namespace crowd::robot_sweep_test {
namespace {

const Footprint DISC{0.3, {}};
/// A bar of 2 m by 0.2 m.
const Footprint BAR{0.0, {{1.0, 0.1}, {-1.0, 0.1}, {-1.0, -0.1}, {1.0, -0.1}}};

TEST(RobotSweep, TouchesAWall) {
  // 0.05 m of the 0.1 m that it drives in a tick.
  const RobotSweep sweep(DISC, Pose(), {{1.0, 0.0}, 0.0}, 0.1);
  EXPECT_NEAR(firstTouch(sweep, Segment{{0.35, -1.0}, {0.35, 1.0}}, 0.0), 0.5, 1e-9);
  EXPECT_EQ(firstTouch(sweep, Segment{{0.41, -1.0}, {0.41, 1.0}}, 0.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(sweep, Segment{{-0.31, -1.0}, {-0.31, 1.0}}, 0.0), NO_IMPACT);
  // Along a wall that it touches, and away from it.
  EXPECT_EQ(firstTouch(sweep, Segment{{-1.0, 0.3}, {1.0, 0.3}}, 0.0), NO_IMPACT);
  EXPECT_EQ(firstTouch(sweep, Segment{{-0.3, -1.0}, {-0.3, 1.0}}, 0.0), NO_IMPACT);
  EXPECT_NEAR(firstTouch(sweep, Segment{{0.3, -1.0}, {0.3, 1.0}}, 0.0), 0.0, 1e-9);
}

TEST(RobotSweep, ABarThatTurnsTouchesAPoint) {
  // The front side is 0.1 m ahead of the axis: it meets a point 0.8 m away at 45 degrees at 45 - asin(0.1 / 0.8)
  // degrees.
  const RobotSweep sweep(BAR, Pose(), {{0.0, 0.0}, PI / 2.0}, 1.0);
  const double share = (45.0 - toDegrees(std::asin(0.125))) / 90.0;
  EXPECT_NEAR(share, 0.4202, 1e-4);
  EXPECT_NEAR(firstTouch(sweep, Vector2(0.8 * unitVector(PI / 4.0)), {0.0, 0.0}, 0.0, 0.0), share, 1e-9);
  // From later on it is the same; behind the touch the bar stays on the point.
  EXPECT_NEAR(firstTouch(sweep, Vector2(0.8 * unitVector(PI / 4.0)), {0.0, 0.0}, 0.0, 0.3), share, 1e-9);
  EXPECT_EQ(firstTouch(sweep, Vector2(1.1 * unitVector(PI / 4.0)), {0.0, 0.0}, 0.0, 0.0), NO_IMPACT);
}

TEST(RobotSweep, BothMove) {
  // 0.4 m apart, 1 m/s and 3 m/s towards each other.
  const RobotSweep sweep(DISC, Pose(), {{1.0, 0.0}, 0.0}, 0.2);
  EXPECT_NEAR(firstTouch(sweep, {0.95, 0.0}, {-0.6, 0.0}, 0.25, 0.0), 0.5, 1e-9);
  const RobotSweep other(BAR, {{1.7, 0.0}, 0.0}, {{-3.0, 0.0}, 0.0}, 0.2);  // its front is at 0.7
  EXPECT_NEAR(firstTouch(sweep, other, 0.0), 0.5, 1e-9);
  // The same speed in the same direction.
  EXPECT_EQ(firstTouch(sweep, {0.56, 0.0}, {0.2, 0.0}, 0.25, 0.0), NO_IMPACT);
}

TEST(RobotSweep, OnceStoppedStays) {
  RobotSweep sweep(DISC, Pose(), {{1.0, 0.0}, 0.0}, 1.0);
  sweep.stopAt(0.25);
  EXPECT_NEAR(sweep.at(1.0).position.x(), 0.25, 1e-15);
  EXPECT_EQ(firstTouch(sweep, Segment{{0.6, -1.0}, {0.6, 1.0}}, 0.25), NO_IMPACT);
  EXPECT_EQ(sweep.pointSpeed(0.25), 0.0);
}

TEST(RobotSweep, ABarThatTouchesAWallTouchesItAgain) {
  // It stops at the wall, and presses on: its distance, which is never negative, must not hide that.
  const Segment wall{{1.05, -1.0}, {1.05, 1.0}};
  RobotSweep sweep(BAR, Pose(), {{1.0, 0.0}, 0.0}, 0.1);
  const double touch = firstTouch(sweep, wall, 0.0);
  EXPECT_NEAR(touch, 0.5, 1e-7);
  const RobotSweep again(BAR, sweep.at(touch), {{1.0, 0.0}, 0.0}, 0.1);
  EXPECT_LT(firstTouch(again, wall, 0.0), 1e-7);
  EXPECT_GT(distance(BAR, again.at(firstTouch(again, wall, 0.0)), wall), 0.0);
  const RobotSweep beside(BAR, sweep.at(touch), {{0.0, 1.0}, 0.0}, 0.1);
  EXPECT_EQ(firstTouch(beside, wall, 0.0), NO_IMPACT);
}

TEST(RobotSweep, ABriefContactBeforeAnotherIsFound) {
  // Driving 0.1 m ahead, the front is in the wall from 0.0200 m on.
  const RobotSweep sweep(BAR, Pose(), {{1.0, 0.0}, 0.0}, 0.1);
  const Segment wall{{1.02, -1.0}, {1.02, 1.0}};
  EXPECT_NEAR(touchUntil(sweep, wall, 0.0, 0.5), 0.2, 1e-7);
  EXPECT_EQ(touchUntil(sweep, wall, 0.0, 0.1), 0.1);
}

TEST(RobotSweep, StraightWayBetweenTwoPoses) {
  const RobotSweep sweep(BAR, {{0.0, 0.0}, 3.0}, {{1.0, 2.0}, -3.0});
  EXPECT_NEAR(sweep.at(0.5).position.y(), 1.0, 1e-15);
  EXPECT_NEAR(std::abs(wrapAngle(sweep.at(0.5).heading)), PI, 1e-15);  // the short way round
}

/// The first of many samples at which a distance is below a limit; NO_IMPACT if none is.
double sampled(const std::function<double(double)>& distance_at, double limit) {
  constexpr int SAMPLES = 10000;
  for (int i = 0; i <= SAMPLES; ++i) {
    const double time = static_cast<double>(i) / SAMPLES;
    if (distance_at(time) < limit) return time;
  }
  return NO_IMPACT;
}

TEST(RobotSweep, AgreesWithSamplesOfTheDistance) {
  int touched = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const auto within = [&](double limit) { return random.uniform(-limit, limit); };
    const Twist twist{{within(1.5), within(1.5)}, within(3.0)};
    const RobotSweep sweep(seed % 4 == 0 ? DISC : BAR, {{within(0.2), within(0.2)}, within(PI)}, twist, 1.0);
    const Vector2 place = random.uniform(0.5, 1.4) * unitVector(within(PI));
    const Vector2 way(within(0.6), within(0.6));
    const double radius = random.uniform(0.1, 0.25);
    const auto apart = [&](double time) {
      return distance(sweep.footprint(), sweep.at(time), Vector2(place + time * way)) - radius;
    };
    if (apart(0.0) <= 0.0) continue;
    const double touch = firstTouch(sweep, place, way, radius, 0.0);
    const double step = (sweep.pointSpeed() + way.norm()) / 10000;  // the distance changes by less between samples
    if (touch == NO_IMPACT) {
      EXPECT_EQ(sampled(apart, -step), NO_IMPACT);
      continue;
    }
    ++touched;
    EXPECT_NEAR(apart(touch), 0.0, 1e-9);
    EXPECT_GE(sampled(apart, 0.0), touch - 1e-9);
  }
  EXPECT_GT(touched, 50);
}

}  // namespace
}  // namespace crowd::robot_sweep_test
