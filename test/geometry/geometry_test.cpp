#include "geometry/geometry.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <string>

#include "support/scenes.h"

namespace crowd::geometry_test {
namespace {

void expectVector(const Vector2& v, double x, double y) {
  EXPECT_NEAR(v.x(), x, 1e-12);
  EXPECT_NEAR(v.y(), y, 1e-12);
}

void expectWrapped(double angle) {
  SCOPED_TRACE(testing::Message() << "angle " << std::setprecision(17) << angle);
  ASSERT_GE(wrapAngle(angle), -PI);
  ASSERT_LT(wrapAngle(angle), PI);
}

TEST(WrapAngle, IsTheExactRemainderOfWholeTurns) {
  for (int i = -4000; i <= 4000; ++i) {
    const double angle = i * 0.00321;
    const double rest = std::remainder(angle, 2.0 * PI);  // never rounded
    EXPECT_EQ(wrapAngle(angle), rest) << "angle " << std::setprecision(17) << angle;
  }
}

TEST(WrapAngle, KeepsAnglesInRange) {
  for (const double angle : {0.0, 1.0, -1.0, PI / 2, -PI, std::nextafter(PI, 0.0), std::nextafter(-PI, 0.0)}) {
    EXPECT_EQ(wrapAngle(angle), angle);
  }
}

TEST(WrapAngle, SubtractsWholeTurns) {
  EXPECT_EQ(wrapAngle(PI), -PI);
  EXPECT_NEAR(wrapAngle(1.5 * PI), -0.5 * PI, 1e-12);
  EXPECT_NEAR(wrapAngle(-1.5 * PI), 0.5 * PI, 1e-12);
  EXPECT_NEAR(wrapAngle(2.0 * PI), 0.0, 1e-12);
  EXPECT_NEAR(wrapAngle(-2.0 * PI), 0.0, 1e-12);
  EXPECT_NEAR(wrapAngle(7.0), 7.0 - 2.0 * PI, 1e-12);
  EXPECT_NEAR(wrapAngle(-7.0), 2.0 * PI - 7.0, 1e-12);
  EXPECT_NEAR(wrapAngle(1.0 + 200.0 * PI), 1.0, 1e-12);
}

TEST(WrapAngle, StaysInRangeAroundOddMultiplesOfPi) {
  for (int k = -2000; k <= 2000; ++k) {
    const double edge = (2 * k + 1) * PI;
    ASSERT_NO_FATAL_FAILURE(expectWrapped(edge));
    ASSERT_NO_FATAL_FAILURE(expectWrapped(std::nextafter(edge, -std::numeric_limits<double>::infinity())));
    ASSERT_NO_FATAL_FAILURE(expectWrapped(std::nextafter(edge, std::numeric_limits<double>::infinity())));
  }
}

TEST(WrapAngle, KeepsTheDirection) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const double size = std::pow(10.0, random.uniform(-3.0, 6.0));
    const double angle = random.uniform(-size, size);
    expectWrapped(angle);
    EXPECT_NEAR(std::sin(wrapAngle(angle)), std::sin(angle), 1e-9);
    EXPECT_NEAR(std::cos(wrapAngle(angle)), std::cos(angle), 1e-9);
  }
}

TEST(WrapAngle, StaysInRangeForHugeAngles) {
  for (double angle = 1e12; angle < 1e300; angle *= 1.7) {
    ASSERT_NO_FATAL_FAILURE(expectWrapped(angle));
    ASSERT_NO_FATAL_FAILURE(expectWrapped(-angle));
  }
}

TEST(Angles, ConvertDegreesAndRadians) {
  EXPECT_DOUBLE_EQ(toRadians(180.0), PI);
  EXPECT_DOUBLE_EQ(toRadians(-45.0), -PI / 4);
  EXPECT_DOUBLE_EQ(toDegrees(PI / 2), 90.0);
}

TEST(Angles, BearingCountsCounterclockwiseFromX) {
  EXPECT_DOUBLE_EQ(bearingOf({2.0, 0.0}), 0.0);
  EXPECT_DOUBLE_EQ(bearingOf({0.0, 3.0}), PI / 2);
  EXPECT_DOUBLE_EQ(bearingOf({-1.0, 0.0}), PI);
  EXPECT_DOUBLE_EQ(bearingOf({1.0, -1.0}), -PI / 4);
  EXPECT_EQ(bearingOf({0.0, 0.0}), 0.0);
}

TEST(Angles, UnitVectorPointsAlongItsHeading) {
  expectVector(unitVector(0.0), 1.0, 0.0);
  expectVector(unitVector(toRadians(90.0)), 0.0, 1.0);
  expectVector(unitVector(toRadians(-135.0)), -std::sqrt(0.5), -std::sqrt(0.5));
}

TEST(Angles, CrossIsPositiveToTheLeft) {
  EXPECT_EQ(cross({1.0, 0.0}, {3.0, 2.0}), 2.0);
  EXPECT_EQ(cross({1.0, 0.0}, {3.0, -2.0}), -2.0);
  EXPECT_EQ(cross({2.0, 1.0}, {4.0, 2.0}), 0.0);
}

TEST(Rotation, QuarterTurnByHand) {
  const Rotation north(toRadians(90.0));
  expectVector(north.intoFrame({0.0, 2.0}), 2.0, 0.0);   // what lies north is ahead
  expectVector(north.intoFrame({1.0, 0.0}), 0.0, -1.0);  // what lies east is on the right
  expectVector(north.outOfFrame({2.0, 0.0}), 0.0, 2.0);
  expectVector(north.outOfFrame({0.0, 1.0}), -1.0, 0.0);
}

TEST(Rotation, ThirtyDegreesByHand) {
  const Rotation frame(toRadians(30.0));
  expectVector(frame.outOfFrame({2.0, 0.0}), std::sqrt(3.0), 1.0);
  expectVector(frame.intoFrame({0.0, 2.0}), 1.0, std::sqrt(3.0));
}

TEST(Rotation, IntoAndOutOfTheFrameAreInverse) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const double heading = random.uniform(-10.0, 10.0);
    const Vector2 v = scenes::randomPoint(random, 100.0);
    const Rotation frame(heading);
    EXPECT_LT((frame.outOfFrame(frame.intoFrame(v)) - v).norm(), 1e-12);
    EXPECT_LT((frame.intoFrame(frame.outOfFrame(v)) - v).norm(), 1e-12);
    EXPECT_NEAR(wrapAngle(bearingOf(v) - bearingOf(frame.intoFrame(v)) - heading + 1.0), 1.0, 1e-9);
    EXPECT_NEAR(frame.intoFrame(v).norm(), v.norm(), 1e-12);
  }
}

TEST(NearestPoint, IsTheFootOrAnEndOfTheSegment) {
  const Segment segment{{1.0, 1.0}, {5.0, 1.0}};
  expectVector(nearestPoint(segment, {2.0, 4.0}), 2.0, 1.0);
  expectVector(nearestPoint(segment, {2.0, -4.0}), 2.0, 1.0);
  expectVector(nearestPoint(segment, {-2.0, 5.0}), 1.0, 1.0);
  expectVector(nearestPoint(segment, {8.0, 5.0}), 5.0, 1.0);
  expectVector(nearestPoint(segment, {3.0, 1.0}), 3.0, 1.0);
  expectVector(nearestPoint({{0.0, 0.0}, {2.0, 2.0}}, {2.0, 0.0}), 1.0, 1.0);
}

TEST(NearestPoint, DistanceByHand) {
  const Segment segment{{1.0, 1.0}, {5.0, 1.0}};
  EXPECT_DOUBLE_EQ(distanceTo(segment, {2.0, 4.0}), 3.0);
  EXPECT_DOUBLE_EQ(distanceTo(segment, {-2.0, 5.0}), 5.0);  // 3, 4, 5 from the end
  EXPECT_DOUBLE_EQ(distanceTo(segment, {3.0, 1.0}), 0.0);
}

TEST(NearestPoint, SegmentWithoutLengthIsAPoint) {
  const Segment point{{2.0, 3.0}, {2.0, 3.0}};
  expectVector(nearestPoint(point, {5.0, 7.0}), 2.0, 3.0);
  EXPECT_DOUBLE_EQ(distanceTo(point, {5.0, 7.0}), 5.0);
}

TEST(NearestPoint, LiesOnTheSegmentAndNoOtherPointIsNearer) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const Segment segment{scenes::randomPoint(random, 5.0), scenes::randomPoint(random, 5.0)};
    const Vector2 p = scenes::randomPoint(random, 8.0);
    const Vector2 nearest = nearestPoint(segment, p);
    const double detour = (nearest - segment.from).norm() + (nearest - segment.to).norm();
    EXPECT_NEAR(detour, (segment.to - segment.from).norm(), 1e-9);
    for (int i = 0; i <= 100; ++i) {
      const Vector2 other = segment.from + 0.01 * i * (segment.to - segment.from);
      EXPECT_LE((nearest - p).norm(), (other - p).norm() + 1e-12);
    }
  }
}

}  // namespace
}  // namespace crowd::geometry_test
