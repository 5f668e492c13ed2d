#include "maps/floor_reach.h"

#include <gtest/gtest.h>

#include "support/floors.h"

namespace crowd::floor_reach_test {
namespace {

constexpr double RADIUS = 0.2;

TEST(FloorReach, AClosedRoomIsConnectedWithNothing) {
  const FloorReach reach(floors::room({0.0, 0.0}, {4.0, 4.0}), RADIUS);
  EXPECT_TRUE(reach.connects({1.0, 1.0}, {3.0, 3.0}));
  EXPECT_TRUE(reach.connects({-1.0, 1.0}, {5.0, 3.0}));
  EXPECT_FALSE(reach.connects({1.0, 1.0}, {-1.0, 1.0}));
  EXPECT_FALSE(reach.connects({500.0, 1.0}, {1.0, 1.0}));  // far beyond the grid
  EXPECT_TRUE(reach.connects({500.0, 1.0}, {-1.0, 1.0}));
  EXPECT_FALSE(reach.connects({0.2, 1.0}, {-1.0, 1.0}));   // touches the wall
  EXPECT_FALSE(reach.connects({0.05, 1.0}, {-1.0, 1.0}));  // a smaller agent at the wall
}

/// A door is passed if it is wider than the body and 0.09 m, to within a cell of 0.05 m.
TEST(FloorReach, ADoorConnectsIfItIsWideEnough) {
  const auto connects = [](double width, double radius) {
    return FloorReach(floors::roomWithDoor(width), radius).connects({-2.0, 0.0}, {2.0, 0.0});
  };
  EXPECT_TRUE(connects(0.55, RADIUS));
  EXPECT_FALSE(connects(0.48, RADIUS));
  EXPECT_FALSE(connects(0.55, 0.3));
}

}  // namespace
}  // namespace crowd::floor_reach_test
