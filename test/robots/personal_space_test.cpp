#include "robots/personal_space.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crowd::personal_space_test {
namespace {

// exp(-1/2), exp(-2): the cost at one and at two standard deviations.
constexpr double ONE = 0.60653066;
constexpr double TWO = 0.13533528;

PersonalSpaceSpec spec() {
  PersonalSpaceSpec spec;
  spec.amplitude = 200.0;
  spec.cutoff = 20.0;
  spec.spread = 0.5;
  spec.stretch = 0.5;
  spec.horizon = 0.0;
  return spec;
}

TEST(PersonalSpace, isCircularAroundAPersonWhoStands) {
  const PersonalSpace space(spec(), Vector2(3.0, -1.0), Vector2::Zero());
  EXPECT_DOUBLE_EQ(space.costAt(Vector2(3.0, -1.0)), 200.0);
  for (double angle = 0.0; angle < 6.2; angle += 0.5) {
    EXPECT_NEAR(space.costAt(Vector2(3.0, -1.0) + 0.5 * unitVector(angle)), 200.0 * ONE, 1e-4);
    EXPECT_NEAR(space.costAt(Vector2(3.0, -1.0) + unitVector(angle)), 200.0 * TWO, 1e-4);
  }
}

TEST(PersonalSpace, isStretchedInFrontOfAPersonWhoWalks) {
  // 2 m/s to the north: the standard deviation ahead is 0.5 m * (1 + 0.5 s/m * 2 m/s) = 1 m.
  const PersonalSpace space(spec(), Vector2::Zero(), Vector2(0.0, 2.0));
  EXPECT_NEAR(space.costAt(Vector2(0.0, 1.0)), 200.0 * ONE, 1e-4);
  EXPECT_NEAR(space.costAt(Vector2(0.0, 2.0)), 200.0 * TWO, 1e-4);
  EXPECT_NEAR(space.costAt(Vector2(0.0, -0.5)), 200.0 * ONE, 1e-4);
  EXPECT_NEAR(space.costAt(Vector2(0.5, 0.0)), 200.0 * ONE, 1e-4);
  EXPECT_NEAR(space.costAt(Vector2(-0.5, 1.0)), 200.0 * ONE * ONE, 1e-4);
}

TEST(PersonalSpace, followsTheWayWithinTheHorizon) {
  PersonalSpaceSpec with_horizon = spec();
  with_horizon.horizon = 1.5;
  // 1 m/s to the west: a way of 1.5 m; the standard deviation ahead is 0.75 m.
  const PersonalSpace space(with_horizon, Vector2::Zero(), Vector2(-1.0, 0.0));
  for (const double x : {0.0, -0.7, -1.5}) {
    EXPECT_NEAR(space.costAt(Vector2(x, 0.0)), 200.0, 1e-9);
    EXPECT_NEAR(space.costAt(Vector2(x, 0.5)), 200.0 * ONE, 1e-4);
  }
  EXPECT_NEAR(space.costAt(Vector2(-2.25, 0.0)), 200.0 * ONE, 1e-4);
  EXPECT_NEAR(space.costAt(Vector2(0.5, 0.0)), 200.0 * ONE, 1e-4);
}

TEST(PersonalSpace, isZeroBelowTheCutoff) {
  // 200 exp(-d^2 / 2) = 20 at d = sqrt(2 ln 10) = 2.14597 standard deviations = 1.07298 m.
  const PersonalSpace space(spec(), Vector2::Zero(), Vector2::Zero());
  EXPECT_NEAR(space.costAt(Vector2(1.0729, 0.0)), 20.0, 0.01);
  EXPECT_EQ(space.costAt(Vector2(1.0731, 0.0)), 0.0);
  const Bounds bounds = space.bounds();
  EXPECT_NEAR(bounds.high.x(), 1.07298, 1e-5);
  EXPECT_NEAR(bounds.low.y(), -1.07298, 1e-5);
}

TEST(PersonalSpace, boundsContainAllCosts) {
  PersonalSpaceSpec with_horizon = spec();
  with_horizon.horizon = 0.5;
  for (double angle = 0.0; angle < 6.2; angle += 0.7) {
    const PersonalSpace space(with_horizon, Vector2(1.0, 2.0), 1.3 * unitVector(angle));
    const Bounds bounds = space.bounds();
    for (double x = -6.0; x < 8.0; x += 0.1) {
      for (double y = -5.0; y < 9.0; y += 0.1) {
        const bool inside = x >= bounds.low.x() && x <= bounds.high.x() && y >= bounds.low.y() && y <= bounds.high.y();
        EXPECT_TRUE(inside || space.costAt(Vector2(x, y)) == 0.0) << angle << ": " << x << ", " << y;
      }
    }
    // 2.14597 standard deviations of 0.825 m beyond a way of 0.65 m.
    EXPECT_GE(space.costAt(Vector2(1.0, 2.0) + 2.42 * unitVector(angle)), 20.0);
    EXPECT_EQ(space.costAt(Vector2(1.0, 2.0) + 2.421 * unitVector(angle)), 0.0);
  }
}

TEST(PersonalSpace, isEmptyIfTheCutoffIsAboveTheAmplitude) {
  PersonalSpaceSpec low = spec();
  low.amplitude = 10.0;
  const PersonalSpace space(low, Vector2::Zero(), Vector2(1.0, 0.0));
  EXPECT_EQ(space.costAt(Vector2::Zero()), 0.0);
  EXPECT_GT(space.bounds().low.x(), space.bounds().high.x());
}

}  // namespace
}  // namespace crowd::personal_space_test
