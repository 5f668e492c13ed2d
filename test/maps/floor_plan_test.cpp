#include "maps/floor_plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "social_crowd/errors.h"
#include "support/error_of.h"

namespace crowd::floor_plan_test {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

std::string refusalOf(const FloorPlan& floor) {
  return errorOf<InputError>([&] { floor.checkedBounds(); });
}

TEST(FloorPlan, BoundsLieAMarginAroundEverything) {
  FloorPlan floor;
  floor.walls = {{{3.0, -1.0}, {-2.0, 5.0}}};
  floor.obstacles = {{{10.0, 0.0}, 2.0}};
  const FloorPlan::Bounds bounds = floor.checkedBounds();
  EXPECT_EQ(bounds.low, Vector2(-6.0, -6.0));  // 4 m beside the wall, and 2 + 4 m below the obstacle's centre
  EXPECT_EQ(bounds.high, Vector2(16.0, 9.0));
}

TEST(FloorPlan, GivenBoundsCount) {
  FloorPlan floor;
  floor.bounds = FloorPlan::Bounds{{0.0, 0.0}, {1.0, 2.0}};
  floor.walls = {{{-10.0, 0.0}, {10.0, 0.0}}};
  EXPECT_EQ(floor.checkedBounds().low, Vector2(0.0, 0.0));
  EXPECT_EQ(floor.checkedBounds().high, Vector2(1.0, 2.0));
}

TEST(FloorPlan, APointIsEnough) {
  FloorPlan floor;
  floor.walls = {{{1.0, 1.0}, {1.0, 1.0}}};  // a wall without length
  EXPECT_EQ(floor.checkedBounds().low, Vector2(-3.0, -3.0));
}

TEST(FloorPlan, InvalidPlansAreRefused) {
  EXPECT_EQ(refusalOf(FloorPlan()), "floor: no bounds, walls or obstacles, expected at least one of them");
  FloorPlan floor;
  floor.walls = {{{0.0, 0.0}, {1.0, 0.0}}, {{0.0, 0.0}, {INFINITE, 0.0}}};
  EXPECT_TRUE(contains(refusalOf(floor), "floor: wall 1 is from [0, 0] to [")) << refusalOf(floor);
  floor.walls.pop_back();
  floor.obstacles = {{{0.0, 0.0}, -0.5}};
  EXPECT_EQ(refusalOf(floor), "floor: obstacle 0 has radius -0.5, expected a number of at least 0 [m]");
  floor.obstacles = {{{0.0, std::nan("")}, 0.5}};
  EXPECT_TRUE(contains(refusalOf(floor), "floor: obstacle 0 is at [0, ")) << refusalOf(floor);
  floor.obstacles.clear();
  floor.bounds = FloorPlan::Bounds{{0.0, 0.0}, {1.0, 0.0}};
  EXPECT_EQ(refusalOf(floor),
            "floor: bounds are from [0, 0] to [1, 0], expected finite numbers [m] and an area above 0");
  floor.bounds = FloorPlan::Bounds{{0.0, 0.0}, {INFINITE, 1.0}};
  EXPECT_TRUE(contains(refusalOf(floor), "floor: bounds are from"));
}

}  // namespace
}  // namespace crowd::floor_plan_test
