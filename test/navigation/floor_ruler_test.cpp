#include "navigation/floor_ruler.h"

#include <gtest/gtest.h>

#include "support/floors.h"

namespace crowd::floor_ruler_test {
namespace {

constexpr double RADIUS = 0.2;
constexpr double STEP = 0.1 + FloorRuler::SPACING;  // of the measurement, and of the grid [m]

/// A corridor of 2 m along the x axis: the centre of a disc of 0.2 m has 0.8 m to both sides of the middle.
TEST(FloorRuler, MeasuresBothSides) {
  const FloorRuler ruler(floors::room({-6.0, -1.0}, {6.0, 1.0}), 1.0);
  const FloorWidth middle = ruler.widthAt({0.0, 0.0}, {1.0, 0.0}, RADIUS, 3.0);
  EXPECT_NEAR(middle.left, 0.8, STEP);
  EXPECT_NEAR(middle.right, 0.8, STEP);
  const FloorWidth aside = ruler.widthAt({0.0, 0.5}, {1.0, 0.0}, RADIUS, 3.0);  // left is north
  EXPECT_NEAR(aside.left, 0.3, STEP);
  EXPECT_NEAR(aside.right, 1.3, STEP);
  const FloorWidth back = ruler.widthAt({0.0, 0.5}, {-1.0, 0.0}, RADIUS, 3.0);
  EXPECT_NEAR(back.left, aside.right, STEP);
  EXPECT_NEAR(back.right, aside.left, STEP);
}

TEST(FloorRuler, StopsAtTheLimit) {
  const FloorRuler ruler(floors::room({-6.0, -4.0}, {6.0, 4.0}), 1.0);
  const FloorWidth width = ruler.widthAt({0.0, 0.0}, {1.0, 0.0}, RADIUS, 1.5);
  EXPECT_GE(width.total(), 1.5);
  EXPECT_LE(width.total(), 1.5 + 2.0 * STEP);
}

TEST(FloorRuler, KnowsTheClearance) {
  const FloorRuler ruler(floors::room({-6.0, -4.0}, {6.0, 4.0}), 1.0);
  EXPECT_TRUE(ruler.hasClearance({0.0, 3.45}, 0.5));
  EXPECT_FALSE(ruler.hasClearance({0.0, 3.6}, 0.5));
  EXPECT_TRUE(ruler.hasClearance({0.0, 0.0}, 1.0));
  EXPECT_TRUE(ruler.hasClearance({100.0, 0.0}, 1.0));  // beyond the grid
}

}  // namespace
}  // namespace crowd::floor_ruler_test
