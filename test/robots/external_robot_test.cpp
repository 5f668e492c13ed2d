#include "robots/external_robot.h"

#include <gtest/gtest.h>

#include <limits>

namespace crowd::external_robot_test {
namespace {

Pose at(double x, double heading = 0.0) { return {{x, 0.0}, heading}; }

/// A robot of at most 1 m/s in ticks of 0.1 s.
ExternalRobot makeRobot() { return {1.0, 0.1}; }

TEST(ExternalRobot, HasNoStateBeforeItsFirstPose) {
  ExternalRobot robot = makeRobot();
  EXPECT_FALSE(robot.at(1.0));
  EXPECT_FALSE(robot.take(at(2.0, 7.0), 1.0));
  const auto state = robot.at(1.0);
  ASSERT_TRUE(state);
  EXPECT_EQ(state->pose.position.x(), 2.0);
  EXPECT_DOUBLE_EQ(state->pose.heading, 7.0 - 2.0 * PI);
  EXPECT_TRUE(state->jumped);  // to its first place
  EXPECT_FALSE(robot.at(1.1)->jumped);
}

TEST(ExternalRobot, MovesOnWithItsVelocityForOneTick) {
  ExternalRobot robot = makeRobot();
  robot.take(at(0.0), 1.0);
  robot.take(at(0.05), 1.1);
  const auto state = robot.at(1.15);
  EXPECT_NEAR(state->velocity.x(), 0.5, 1e-12);
  EXPECT_NEAR(state->pose.position.x(), 0.075, 1e-12);
  EXPECT_NEAR(robot.at(1.2)->pose.position.x(), 0.1, 1e-12);
  EXPECT_NEAR(robot.at(1.5)->pose.position.x(), 0.1, 1e-12);
  EXPECT_NEAR(robot.at(1.0)->pose.position.x(), 0.05, 1e-12);
}

TEST(ExternalRobot, ReportsJumps) {
  ExternalRobot robot = makeRobot();
  robot.take(at(0.0), 1.0);
  robot.at(1.0);
  EXPECT_FALSE(robot.take(at(0.24), 1.1));  // 0.15 m at 1.5 times its speed, and 0.1 m
  EXPECT_FALSE(robot.at(1.1)->jumped);
  EXPECT_EQ(robot.take(at(0.5), 1.2), PoseProblem::JUMP);
  const auto state = robot.at(1.3);
  EXPECT_TRUE(state->jumped);
  EXPECT_EQ(state->pose.position.x(), 0.5);
  EXPECT_EQ(state->velocity.x(), 0.0);
  EXPECT_EQ(robot.counts().jumps, 1U);
  EXPECT_FALSE(robot.take(at(0.55), 1.3));
  EXPECT_DOUBLE_EQ(robot.at(1.3)->velocity.x(), 0.5);
}

TEST(ExternalRobot, ReportsGaps) {
  ExternalRobot robot = makeRobot();
  robot.take(at(0.0), 1.0);
  EXPECT_FALSE(robot.take(at(0.1), 1.5));
  EXPECT_TRUE(robot.at(1.5)->jumped);  // the first pose
  EXPECT_EQ(robot.take(at(0.2), 2.25), PoseProblem::GAP);
  EXPECT_EQ(robot.at(2.25)->velocity.x(), 0.0);
  EXPECT_TRUE(robot.take(at(0.3), 3.0).has_value());
  EXPECT_TRUE(robot.at(3.0)->jumped);
  EXPECT_FALSE(robot.at(3.0)->jumped);
  EXPECT_EQ(robot.counts().gaps, 2U);
}

TEST(ExternalRobot, StandsStillWhileItsPoseIsStale) {
  ExternalRobot robot = makeRobot();
  robot.take(at(0.0), 1.0);
  robot.take(at(0.1), 1.25);
  EXPECT_FALSE(robot.at(1.75)->stale);
  for (const double time : {1.76, 1.86}) {
    const auto state = robot.at(time);
    EXPECT_TRUE(state->stale);
    EXPECT_EQ(state->pose.position.x(), 0.1);
    EXPECT_EQ(state->velocity.x(), 0.0);
  }
  EXPECT_EQ(robot.counts().stale, 1U);
  EXPECT_EQ(robot.take(at(0.1), 1.9), PoseProblem::GAP);
  EXPECT_FALSE(robot.at(1.9)->stale);
}

TEST(ExternalRobot, IsStaleWithoutAnyPose) {
  ExternalRobot robot = makeRobot();
  EXPECT_FALSE(robot.at(1.0));
  EXPECT_FALSE(robot.at(1.5));
  EXPECT_FALSE(robot.isStale());
  EXPECT_FALSE(robot.at(1.6));
  EXPECT_TRUE(robot.isStale());
  EXPECT_EQ(robot.counts().stale, 1U);
}

TEST(ExternalRobot, APoseOfALaterClockIsStale) {
  ExternalRobot robot = makeRobot();
  robot.take(at(1.0), 1000.0);
  EXPECT_TRUE(robot.at(1.0)->stale);
  EXPECT_FALSE(robot.at(999.6)->stale);
}

TEST(ExternalRobot, TakesPosesAgainAfterOneOfALaterClock) {
  ExternalRobot robot = makeRobot();
  robot.take(at(1.0), 1000.0);
  robot.at(1.0);
  EXPECT_FALSE(robot.take(at(5.0), 1.0));
  const auto state = robot.at(1.1);
  EXPECT_EQ(state->pose.position.x(), 5.0);
  EXPECT_TRUE(state->jumped);
  EXPECT_FALSE(state->stale);
  EXPECT_EQ(robot.take(at(4.0), 0.9), PoseProblem::BACKWARDS);
}

TEST(ExternalRobot, AnEpisodeKeepsThePoseAndForgetsTheCounts) {
  ExternalRobot robot = makeRobot();
  robot.take(at(1.0), 1.0);
  robot.take(at(9.0), 1.1);
  robot.at(1.1);
  robot.begin(1.0, 0.1);
  EXPECT_EQ(robot.counts().jumps, 0U);
  EXPECT_EQ(robot.counts().taken, 0U);
  const auto state = robot.at(1.2);
  EXPECT_EQ(state->pose.position.x(), 9.0);
  EXPECT_TRUE(state->jumped);  // from the place in the scenario
}

TEST(ExternalRobot, IgnoresBadPoses) {
  ExternalRobot robot = makeRobot();
  robot.take(at(0.5), 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(robot.take(at(nan), 1.1), PoseProblem::NOT_FINITE);
  EXPECT_EQ(robot.take(at(0.0, nan), 1.1), PoseProblem::NOT_FINITE);
  EXPECT_EQ(robot.take(at(0.0), std::numeric_limits<double>::infinity()), PoseProblem::NOT_FINITE);
  EXPECT_EQ(robot.take(at(0.0), 0.9), PoseProblem::BACKWARDS);
  EXPECT_FALSE(robot.take(at(0.0), 1.0));  // repeated
  EXPECT_EQ(robot.at(1.0)->pose.position.x(), 0.5);
  EXPECT_EQ(robot.counts().not_finite, 3U);
  EXPECT_EQ(robot.counts().backwards, 1U);
  EXPECT_EQ(robot.counts().taken, 1U);
}

TEST(ExternalRobot, IgnoresPosesBeyondTheGreatestPlace) {
  ExternalRobot robot = makeRobot();
  for (const double far : {1e6 + 1.0, -1e308}) {
    EXPECT_EQ(robot.take(at(far), 1.0), PoseProblem::NOT_FINITE);
    EXPECT_EQ(robot.take({{0.0, far}, 0.0}, 1.0), PoseProblem::NOT_FINITE);
  }
  EXPECT_FALSE(robot.at(1.0).has_value());
  // It does not move on beyond it either.
  robot.take(at(1e6 - 0.04), 1.1);
  robot.take(at(1e6), 1.2);
  EXPECT_EQ(robot.at(1.25)->pose.position.x(), 1e6);
}

TEST(ExternalRobot, IsNotFasterThanWithoutAJump) {
  // 0.09 m in a nanosecond is not a jump.
  ExternalRobot robot = makeRobot();
  robot.take(at(0.0), 1.0);
  EXPECT_FALSE(robot.take(at(0.09), 1.0 + 1e-9));
  EXPECT_NEAR(robot.at(1.0)->velocity.x(), ExternalRobot::JUMP_SPEED * 1.0, 1e-9);
  // Nor than any body may be.
  ExternalRobot fast(1e3, 0.1);
  fast.take(at(0.0), 1.0);
  EXPECT_FALSE(fast.take(at(0.09), 1.0 + 1e-9));
  EXPECT_EQ(fast.at(1.0)->velocity.x(), 1e3);
}

}  // namespace
}  // namespace crowd::external_robot_test
