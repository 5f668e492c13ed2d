#include "geometry/drive.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/random.h"

namespace crowd::drive_test {
namespace {

constexpr double NO_LIMIT = 1e9;

DriveLimits limitsOf(double speed, double rotation, double acceleration) {
  return {speed, rotation, acceleration, NO_LIMIT, 0.0};
}

void expectNear(const Pose& pose, const Vector2& position, double heading, double tolerance) {
  EXPECT_NEAR(pose.position.x(), position.x(), tolerance);
  EXPECT_NEAR(pose.position.y(), position.y(), tolerance);
  EXPECT_NEAR(wrapAngle(pose.heading - heading), 0.0, tolerance);
}

TEST(DrivePose, FollowsAnArc) {
  // A quarter of a circle of radius v / w = 2 / pi.
  expectNear(drivePose({}, {{1.0, 0.0}, PI / 2.0}, 1.0), {2.0 / PI, 2.0 / PI}, PI / 2.0, 1e-15);
  // Sideways to the left while it turns by half a circle of radius 1 / pi, whose centre is 1 / pi behind it.
  expectNear(drivePose({}, {{0.0, 1.0}, PI}, 1.0), {-2.0 / PI, 0.0}, -PI, 1e-15);
  // From another pose: to the north, then to the west.
  expectNear(drivePose({{3.0, 4.0}, PI / 2.0}, {{1.0, 0.0}, PI / 2.0}, 1.0), {3.0 - 2.0 / PI, 4.0 + 2.0 / PI}, PI,
             1e-15);
}

TEST(DrivePose, IsStraightWithoutRotation) {
  expectNear(drivePose({{1.0, 2.0}, 0.5}, {{2.0, 0.0}, 0.0}, 0.5), Vector2(1.0, 2.0) + unitVector(0.5), 0.5, 1e-15);
  // With a small rotation w the end is v w t^2 / 2 to the left.
  expectNear(drivePose({}, {{1.0, 0.0}, 1e-9}, 1.0), {1.0, 0.5e-9}, 1e-9, 1e-18);
}

TEST(DrivePose, OfTenTicksIsThatOfTenfoldTime) {
  const Twist twist{{0.8, -0.3}, 1.7};
  Pose pose{{0.5, -2.0}, 2.5};
  const Pose at_once = drivePose(pose, twist, 1.0);
  for (int tick = 0; tick < 10; ++tick) pose = drivePose(pose, twist, 0.1);
  expectNear(pose, at_once.position, at_once.heading, 1e-12);
}

TEST(LimitTwist, AcceleratesFromRest) {
  Twist twist;
  Pose pose;
  for (int tick = 1; tick <= 12; ++tick) {
    twist = limitTwist(Drive::DIFFERENTIAL, limitsOf(2.0, 1.0, 1.0), twist, {{1.0, 0.0}, 0.0}, 0.1);
    EXPECT_NEAR(twist.linear.x(), std::min(1.0, 0.1 * tick), 1e-12) << "tick " << tick;
    if (tick <= 10) pose = drivePose(pose, twist, 0.1);
  }
  EXPECT_NEAR(pose.position.x(), 0.55, 1e-12);  // 0.1 s * (0.1 + 0.2 + ... + 1.0) m/s
  // It brakes at the same rate.
  EXPECT_NEAR(limitTwist(Drive::DIFFERENTIAL, limitsOf(2.0, 1.0, 1.0), twist, {}, 0.1).linear.x(), 0.9, 1e-12);
}

TEST(LimitTwist, LimitsRotationAndItsChange) {
  const DriveLimits limits{1.0, 1.0, 1.0, 2.0, 0.0};
  const Twist first = limitTwist(Drive::DIFFERENTIAL, limits, {}, {{0.0, 0.0}, 5.0}, 0.1);
  EXPECT_NEAR(first.rotation, 0.2, 1e-15);
  const Twist last = limitTwist(Drive::DIFFERENTIAL, limits, {{0.0, 0.0}, 0.95}, {{0.0, 0.0}, 5.0}, 0.1);
  EXPECT_EQ(last.rotation, 1.0);
  EXPECT_NEAR(limitTwist(Drive::DIFFERENTIAL, limits, last, {{0.0, 0.0}, -5.0}, 0.1).rotation, 0.8, 1e-15);
}

TEST(LimitTwist, KeepsTheDirectionOfAHolonomicRobot) {
  const DriveLimits limits = limitsOf(1.0, 1.0, NO_LIMIT);
  const Twist fast = limitTwist(Drive::HOLONOMIC, limits, {}, {{3.0, 4.0}, 0.0}, 0.1);
  EXPECT_NEAR(fast.linear.x(), 0.6, 1e-15);
  EXPECT_NEAR(fast.linear.y(), 0.8, 1e-15);
  // The change of velocity is limited, too: 0.1 m/s from (1, 0) towards (0, 1).
  const Twist turned = limitTwist(Drive::HOLONOMIC, limitsOf(1.0, 1.0, 1.0), {{1.0, 0.0}, 0.0}, {{0.0, 1.0}, 0.0}, 0.1);
  EXPECT_NEAR(turned.linear.x(), 1.0 - 0.1 * std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(turned.linear.y(), 0.1 * std::sqrt(0.5), 1e-15);
}

TEST(LimitTwist, OtherDrivesDoNotMoveSideways) {
  EXPECT_EQ(limitTwist(Drive::DIFFERENTIAL, limitsOf(1.0, 1.0, NO_LIMIT), {}, {{0.5, 0.5}, 0.0}, 0.1).linear,
            Vector2(0.5, 0.0));
}

TEST(LimitTwist, ACarTurnsOnCurvesOnly) {
  const DriveLimits limits{1.0, 10.0, NO_LIMIT, NO_LIMIT, 2.0};
  EXPECT_EQ(limitTwist(Drive::ACKERMANN, limits, {}, {{1.0, 0.0}, 3.0}, 0.1).rotation, 0.5);  // v / radius
  EXPECT_EQ(limitTwist(Drive::ACKERMANN, limits, {}, {{-1.0, 0.0}, -3.0}, 0.1).rotation, -0.5);
  EXPECT_EQ(limitTwist(Drive::ACKERMANN, limits, {}, {{0.0, 0.0}, 3.0}, 0.1).rotation, 0.0);
  // Also while it accelerates: at 0.1 m/s.
  const DriveLimits slow{1.0, 10.0, 1.0, NO_LIMIT, 2.0};
  EXPECT_NEAR(limitTwist(Drive::ACKERMANN, slow, {}, {{1.0, 0.0}, 3.0}, 0.1).rotation, 0.05, 1e-15);
}

TEST(Deviation, IsBoundedByAccelerationAndRotation) {
  EXPECT_NEAR(deviation(limitsOf(1.0, 1.0, 1.0), 0.1), 0.015, 1e-15);      // 1 * 0.01 + 1 * 1 * 0.01 / 2
  EXPECT_NEAR(deviation(limitsOf(1.0, 0.0, NO_LIMIT), 0.25), 0.5, 1e-15);  // from 1 m/s ahead to 1 m/s back
}

TEST(Twist, IsFiniteIfAllItsNumbersAre) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_TRUE((Twist{{1.0, -2.0}, 3.0}.isFinite()));
  EXPECT_FALSE((Twist{{nan, 0.0}, 0.0}.isFinite()));
  EXPECT_FALSE((Twist{{0.0, infinity}, 0.0}.isFinite()));
  EXPECT_FALSE((Twist{{0.0, 0.0}, -infinity}.isFinite()));
}

TEST(Drive, TheTwistBetweenTwoPosesLeadsFromOneToTheOther) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const auto within = [&](double limit) { return random.uniform(-limit, limit); };
    const Pose from{{within(5.0), within(5.0)}, within(PI)};
    const Twist twist{{within(2.0), within(2.0)}, within(3.0)};
    const Twist found = twistBetween(from, drivePose(from, twist, 0.4), 0.4);
    EXPECT_NEAR((found.linear - twist.linear).norm(), 0.0, 1e-12);
    EXPECT_NEAR(found.rotation, twist.rotation, 1e-12);
  }
  // A quarter of a circle of radius 2 m in 1 s.
  const Twist quarter = twistBetween({{0.0, 0.0}, 0.0}, {{2.0, 2.0}, PI / 2.0}, 1.0);
  EXPECT_NEAR(quarter.linear.x(), PI, 1e-12);
  EXPECT_NEAR(quarter.linear.y(), 0.0, 1e-12);
  EXPECT_NEAR(quarter.rotation, PI / 2.0, 1e-12);
}

}  // namespace
}  // namespace crowd::drive_test
