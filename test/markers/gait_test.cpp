#include "ros/markers/marker_gait.h"

#include <gtest/gtest.h>

namespace crowd::gait_test {
namespace {

constexpr double STEP = WalkingCycles::STRIDE / WalkingCycles::FRAMES;  // distance from one frame to the next: 0.175 m

Pose at(double x, double heading = 0.0) { return {Vector2(x, 0.0), heading}; }

TEST(WalkingCycles, UnseenAndNewPersonsStand) {
  WalkingCycles cycles;
  EXPECT_EQ(cycles.frameOf(0), WalkingCycles::STANDING);
  cycles.walk(0, at(0.0));
  EXPECT_EQ(cycles.frameOf(0), WalkingCycles::STANDING);
}

TEST(WalkingCycles, FramesFollowTheDistance) {
  WalkingCycles cycles;
  cycles.walk(0, at(0.0));
  cycles.walk(0, at(0.1));
  EXPECT_EQ(cycles.frameOf(0), 0);  // 0.1 of 0.175 m
  cycles.walk(0, at(0.2));
  EXPECT_EQ(cycles.frameOf(0), 1);
  cycles.walk(0, at(1.0));
  EXPECT_EQ(cycles.frameOf(0), 5);  // 1.0 / 0.175 = 5.7
  cycles.walk(0, at(1.39));
  EXPECT_EQ(cycles.frameOf(0), 7);
  cycles.walk(0, at(1.41));
  EXPECT_EQ(cycles.frameOf(0), 0);  // the next cycle
}

TEST(WalkingCycles, BackwardsRunsBackwards) {
  WalkingCycles cycles;
  cycles.walk(0, at(0.0));
  cycles.walk(0, at(-0.1));
  EXPECT_EQ(cycles.frameOf(0), 7);
  cycles.walk(0, at(-0.3));
  EXPECT_EQ(cycles.frameOf(0), 6);
  cycles.walk(0, at(-0.5, PI));  // turned round: forwards again, to a distance of -0.1 m
  EXPECT_EQ(cycles.frameOf(0), 7);
}

TEST(WalkingCycles, SidewaysIsForwards) {
  WalkingCycles cycles;
  cycles.walk(0, at(0.0, 0.25 * PI));
  cycles.walk(0, at(1.5 * STEP, 0.25 * PI));
  EXPECT_EQ(cycles.frameOf(0), 1);
}

TEST(WalkingCycles, StandsAfterSomeStatesWithoutMovement) {
  WalkingCycles cycles;
  cycles.walk(0, at(0.0));
  cycles.walk(0, at(0.2));
  for (int i = 1; i < WalkingCycles::STILL_STATES; ++i) {
    cycles.walk(0, at(0.2));
    EXPECT_EQ(cycles.frameOf(0), 1) << i;
  }
  cycles.walk(0, at(0.2));
  EXPECT_EQ(cycles.frameOf(0), WalkingCycles::STANDING);
  cycles.walk(0, at(0.36));  // goes on where it stopped
  EXPECT_EQ(cycles.frameOf(0), 2);
}

TEST(WalkingCycles, SlowMovementsAddUp) {
  WalkingCycles cycles;
  cycles.walk(0, at(0.0));
  for (int i = 1; i <= 60; ++i) cycles.walk(0, at(0.004 * i));  // 0.24 m; each is shorter than LEAST_MOVE
  EXPECT_EQ(cycles.frameOf(0), 1);
}

TEST(WalkingCycles, ATeleportIsNoStep) {
  WalkingCycles cycles;
  cycles.walk(0, at(0.0));
  cycles.walk(0, at(0.2));
  cycles.walk(0, at(50.0));
  EXPECT_EQ(cycles.frameOf(0), 1);
  cycles.walk(0, at(50.2));  // 0.4 m in all
  EXPECT_EQ(cycles.frameOf(0), 2);
}

TEST(WalkingCycles, NeighboursAreOutOfStepAndIndependent) {
  WalkingCycles cycles;
  for (const std::uint32_t person : {0U, 1U}) {
    cycles.walk(person, at(0.0));
    cycles.walk(person, at(0.1));
  }
  EXPECT_EQ(cycles.frameOf(0), 0);
  EXPECT_EQ(cycles.frameOf(1), 5);  // (0.618 + 0.1 / 1.4) * 8 = 5.5
  cycles.walk(1, at(0.2));
  EXPECT_EQ(cycles.frameOf(0), 0);
  EXPECT_EQ(cycles.frameOf(1), 6);
  cycles.clear();
  EXPECT_EQ(cycles.frameOf(1), WalkingCycles::STANDING);
}

TEST(WalkingCycles, ForgetsOthers) {
  WalkingCycles cycles;
  for (const std::uint32_t person : {0U, 1U, 2U}) {
    cycles.walk(person, at(0.0));
    cycles.walk(person, at(0.1));
  }
  cycles.keepOnly({0, 2, 7});
  EXPECT_EQ(cycles.size(), 2U);
  EXPECT_EQ(cycles.frameOf(1), WalkingCycles::STANDING);
  EXPECT_NE(cycles.frameOf(2), WalkingCycles::STANDING);
}

}  // namespace
}  // namespace crowd::gait_test
