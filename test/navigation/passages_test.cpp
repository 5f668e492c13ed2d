#include "social_crowd/navigation/passages.h"

#include <gtest/gtest.h>

namespace crowd {
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

}  // namespace
}  // namespace crowd
