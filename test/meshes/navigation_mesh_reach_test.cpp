// What a navigation mesh connects: narrow passages, margins, goals out of reach, invalid input.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "meshes/navigation_mesh.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/floors.h"

namespace crowd::navigation_mesh_reach_test {
namespace {

using Query = NavigationMesh::Query;

constexpr double CLEARANCE = 0.3;
constexpr double CELL = NavigationMesh::DEFAULT_CELL_SIZE;

TEST(NavigationMeshReach, ADoorThatIsTooNarrowIsNotPassed) {
  const NavigationMesh mesh(floors::roomWithDoor(2.0 * CLEARANCE - CELL), CLEARANCE);
  Query query(mesh);
  EXPECT_NE(query.component({-3.0, 0.0}), query.component({3.0, 0.0}));
  EXPECT_FALSE(query.findPath({-3.0, 0.0}, {3.0, 0.0}));
  EXPECT_FALSE(query.isStraight({-3.0, 0.0}, {3.0, 0.0}));
}

TEST(NavigationMeshReach, TheWayRoundIsTakenIfADoorIsTooNarrow) {
  FloorPlan floor = floors::roomWithDoor(2.0 * CLEARANCE - CELL);
  floor.walls.back().to = {0.0, 2.0};  // open from y = 2 to y = 4
  Query query{NavigationMesh(floor, CLEARANCE)};
  const auto path = query.findPath({-3.0, 0.0}, {3.0, 0.0});
  ASSERT_TRUE(path);
  EXPECT_GT(path->length, 2.0 * std::sqrt(13.0));
  EXPECT_GE(floors::clearanceOf(floor, {-3.0, 0.0}, *path), CLEARANCE - 0.43 * CELL);
}

TEST(NavigationMeshReach, AWayLongerThanTheMaximumIsNotFound) {
  Query query{NavigationMesh(floors::roomWithDoor(1.2, 2.6), CLEARANCE)};
  const Vector2 from(-3.0, 0.0);
  const auto path = query.findPath(from, -from);
  ASSERT_TRUE(path);
  EXPECT_GT(path->length, 6.5);  // through the door, not straight
  EXPECT_TRUE(query.findPath(from, -from, 1.001 * path->length));
  EXPECT_FALSE(query.findPath(from, -from, 0.999 * path->length));
  EXPECT_FALSE(query.findPath(from, -from, 6.1));
}

TEST(NavigationMeshReach, ADoorTwoCellsWiderIsPassedInAnyDirection) {
  for (int degrees = 0; degrees < 180; degrees += 7) {
    SCOPED_TRACE("wall turned by " + std::to_string(degrees) + " degrees");
    const Vector2 along = unitVector(toRadians(degrees));
    const Vector2 across(-along.y(), along.x());
    const double half = CLEARANCE + CELL;
    FloorPlan floor;
    floor.bounds = FloorPlan::Bounds{{-3.0, -3.0}, {3.0, 3.0}};
    floor.walls = {{half * along, 9.0 * along}, {-half * along, -9.0 * along}};
    Query query{NavigationMesh(floor, CLEARANCE)};
    const auto path = query.findPath(-2.0 * across, 2.0 * across);
    ASSERT_TRUE(path);
    EXPECT_NEAR(path->length, 4.0, 0.02);
  }
}

TEST(NavigationMeshReach, AClosedRoomIsOutOfReach) {
  FloorPlan floor = floors::room({0.0, 0.0}, {10.0, 10.0});
  const FloorPlan closet = floors::room({4.0, 4.0}, {6.0, 6.0});
  floor.walls.insert(floor.walls.end(), closet.walls.begin(), closet.walls.end());
  const NavigationMesh mesh(floor, CLEARANCE);
  EXPECT_EQ(mesh.componentCount(), 3U);  // with the margin outside of the walls
  Query query(mesh);
  EXPECT_FALSE(query.findPath({1.0, 1.0}, {5.0, 5.0}));
  EXPECT_FALSE(query.findPath({5.0, 5.0}, {1.0, 1.0}));
  EXPECT_FALSE(query.findPath({1.0, 1.0}, {-1.0, 1.0}));
  EXPECT_TRUE(query.findPath({4.5, 4.5}, {5.5, 5.5}));
}

TEST(NavigationMeshReach, AGoalInsideAnObstacleIsOutOfReach) {
  FloorPlan floor = floors::room({0.0, 0.0}, {10.0, 10.0});
  floor.obstacles = {{{5.0, 5.0}, 1.0}};
  Query query{NavigationMesh(floor, CLEARANCE)};
  EXPECT_FALSE(query.findPath({1.0, 1.0}, {5.0, 5.0}));
  EXPECT_FALSE(query.component({5.0, 5.0}));
}

TEST(NavigationMeshReach, AStartInTheMarginOfAWallIsLedOutOfIt) {
  const FloorPlan floor = floors::room({0.0, 0.0}, {10.0, 8.0});
  Query query{NavigationMesh(floor, CLEARANCE)};
  const Vector2 start(4.0, 0.1);
  EXPECT_FALSE(query.contains(start));
  const auto path = query.findPath(start, {9.0, 7.9});
  ASSERT_TRUE(path);
  ASSERT_EQ(path->corners.size(), 3U);
  // Straight out, straight to the point nearest to the goal, and into the margin again.
  EXPECT_NEAR(path->corners[0].x(), 4.0, 1e-6);
  EXPECT_GE(path->corners[0].y(), CLEARANCE - 0.43 * CELL);
  EXPECT_LE(path->corners[0].y(), CLEARANCE + 2.0 * CELL);
  EXPECT_EQ(path->corners[2], Vector2(9.0, 7.9));
  EXPECT_NEAR(path->length, floors::lengthOf(start, *path), 1e-12);
}

TEST(NavigationMeshReach, TheOtherSideOfAWallIsNotNearest) {
  // A point beside a wall belongs to its own side, at any distance from the wall beyond the tolerance.
  FloorPlan floor = floors::roomWithDoor(0.0);
  const NavigationMesh mesh(floor, CLEARANCE);
  Query query(mesh);
  for (double x = mesh.tolerance() + 0.005; x < 0.5; x += 0.01) {
    EXPECT_EQ(query.component({x, 0.3}), query.component({3.0, 0.0})) << x;
    EXPECT_EQ(query.component({-x, 0.3}), query.component({-3.0, 0.0})) << x;
  }
}

TEST(NavigationMeshReach, PointsFarFromTheMeshHaveNoWay) {
  Query query{NavigationMesh(floors::room({0.0, 0.0}, {10.0, 8.0}), CLEARANCE)};
  EXPECT_FALSE(query.findPath({1.0, 1.0}, {100.0, 1.0}));
  EXPECT_FALSE(query.nearestPoint({100.0, 1.0}, 1.0));
  ASSERT_TRUE(query.nearestPoint({1.0, 0.0}, 0.5));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(query.findPath({1.0, nan}, {2.0, 1.0}));
  EXPECT_FALSE(query.findPath({1.0, 1.0}, {1e300, 1.0}));
  EXPECT_FALSE(query.nearestPoint({1.0, 1.0}, -1.0));
}

TEST(NavigationMeshReach, InvalidNumbersAreRefused) {
  const FloorPlan floor = floors::room({0.0, 0.0}, {10.0, 8.0});
  const auto error_of = [&](double clearance, double cell_size) {
    return errorOf<InputError>([&] { NavigationMesh(floor, clearance, cell_size); });
  };
  EXPECT_EQ(error_of(0.0, 0.05), "navigation mesh: clearance is 0, expected a number above 0 [m]");
  EXPECT_TRUE(contains(error_of(std::numeric_limits<double>::quiet_NaN(), 0.05), "clearance is "));
  EXPECT_EQ(error_of(0.3, -1.0), "navigation mesh: cell size is -1, expected a number above 0 [m]");
  const auto too_large = errorOf<InputError>([] { NavigationMesh(floors::room({0.0, 0.0}, {1e6, 1e6}), CLEARANCE); });
  EXPECT_TRUE(contains(too_large, "too large")) << too_large;
  EXPECT_TRUE(contains(errorOf<InputError>([] { NavigationMesh(FloorPlan(), CLEARANCE); }), "no bounds"));
}

}  // namespace
}  // namespace crowd::navigation_mesh_reach_test
