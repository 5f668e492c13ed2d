#include "meshes/navigation_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/floors.h"

namespace crowd::navigation_mesh_test {
namespace {

using Query = NavigationMesh::Query;

constexpr double CLEARANCE = 0.3;
/// The mesh contains every point that is two cells farther from walls than the clearance, and no point that is closer
/// than the clearance less the tolerance; so the length of a path is between the shortest ones for these two radii.
constexpr double FARTHER = CLEARANCE + 2.0 * NavigationMesh::DEFAULT_CELL_SIZE;
const double CLOSER = CLEARANCE - 0.43 * NavigationMesh::DEFAULT_CELL_SIZE;

TEST(NavigationMesh, PathInAnEmptyRoomIsStraight) {
  Query query{NavigationMesh(floors::room({0.0, 0.0}, {10.0, 8.0}), CLEARANCE)};
  const auto path = query.findPath({1.0, 1.0}, {9.0, 7.0});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->corners.size(), 1U);
  EXPECT_EQ(path->corners.back(), Vector2(9.0, 7.0));
  EXPECT_NEAR(path->length, 10.0, 1e-12);
  EXPECT_TRUE(query.isStraight({1.0, 1.0}, {9.0, 7.0}));
}

TEST(NavigationMesh, PathToTheStartHasNoLength) {
  Query query{NavigationMesh(floors::room({0.0, 0.0}, {10.0, 8.0}), CLEARANCE)};
  const auto path = query.findPath({2.0, 3.0}, {2.0, 3.0});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->length, 0.0);
  EXPECT_EQ(path->corners.back(), Vector2(2.0, 3.0));
}

/// Length of the shortest way of a point that keeps `radius` from (0, 2), from (-3, 0) above it to (3, 0): two
/// tangents, and an arc of twice the angle between the x axis and a tangent.
double lengthOverDoorpost(double radius) {
  const double distance = std::sqrt(13.0);
  const double angle = std::atan2(2.0, 3.0) + std::asin(radius / distance);
  return 2.0 * std::sqrt(13.0 - radius * radius) + 2.0 * angle * radius;
}

TEST(NavigationMesh, PathThroughADoorIsShortest) {
  EXPECT_NEAR(lengthOverDoorpost(0.3), 7.5889, 1e-4);      // by hand
  const FloorPlan floor = floors::roomWithDoor(1.2, 2.6);  // from y = 2 to y = 3.2
  Query query{NavigationMesh(floor, CLEARANCE)};
  const auto path = query.findPath({-3.0, 0.0}, {3.0, 0.0});
  ASSERT_TRUE(path);
  EXPECT_GE(path->length, lengthOverDoorpost(CLOSER));
  EXPECT_LE(path->length, lengthOverDoorpost(FARTHER));
  EXPECT_FALSE(query.isStraight({-3.0, 0.0}, {3.0, 0.0}));
  EXPECT_TRUE(query.isStraight({-3.0, 0.0}, path->corners.front()));
}

/// The same for the way out of a U with corners (-2, 2) and (2, 2) that is open to the left, from (0, 0) to (4, 0).
double lengthRoundTheU(double radius) {
  const double tangent = std::sqrt(8.0 - radius * radius);
  const double aside = std::asin(radius / std::sqrt(8.0));
  const double first_turn = 0.75 * PI + aside;
  const double second_turn = 0.25 * PI + aside;
  return 2.0 * tangent + 4.0 + (first_turn + second_turn) * radius;
}

/// A room with a wall that has two doors. The way round the nearer one leads through the other one.
/// Half a millimetre beside the mesh counts as on it.
TEST(NavigationMesh, FindsAWayToAGoalBesideTheRim) {
  Query query{NavigationMesh(floors::roomWithDoor(1.2, 2.6), CLEARANCE)};
  for (const double y : {-1.0, 0.0, 1.0}) {
    const auto rim = query.nearestPoint({0.1, y}, CLEARANCE);
    ASSERT_TRUE(rim);
    for (const double beside : {0.0, 0.0001, 0.0005, 0.0009}) {
      const Vector2 goal(rim->x() - beside, y);
      const auto path = query.findPath({-3.0, 0.0}, goal);
      ASSERT_TRUE(path) << goal.transpose();
      EXPECT_EQ(path->corners.back(), goal);
      EXPECT_TRUE(query.findPath(goal, {-3.0, 0.0})) << goal.transpose();
    }
  }
}

TEST(NavigationMesh, FindsAWayAroundADisc) {
  FloorPlan floor = floors::room({-5.0, -4.0}, {5.0, 6.0});
  floor.walls.push_back({{0.0, -4.0}, {0.0, -0.5}});
  floor.walls.push_back({{0.0, 0.5}, {0.0, 3.5}});
  floor.walls.push_back({{0.0, 4.5}, {0.0, 6.0}});
  Query query{NavigationMesh(floor, CLEARANCE)};
  const Vector2 from(-4.0, 0.0);
  const Vector2 to(4.0, 0.0);
  const FloorPlan::Disc door{{0.0, 0.0}, 0.2};
  const auto path = query.findWayAround(door, from, to, 20.0);
  ASSERT_TRUE(path);
  EXPECT_GT(path->length, 2.0 * std::hypot(4.0, 3.5));  // past (0, 3.5)
  EXPECT_LT(path->length, 2.0 * std::hypot(4.0, 4.0));
  EXPECT_FALSE(query.findWayAround(door, from, to, 10.0));
  EXPECT_FALSE(query.findWayAround({{0.0, 2.0}, 3.0}, from, to, 100.0));
  EXPECT_NEAR(query.findPath(from, to)->length, 8.0, 1e-9);  // the disc is forgotten
}

TEST(NavigationMesh, PathOutOfATrapIsShortest) {
  EXPECT_NEAR(lengthRoundTheU(0.3), 10.6312, 1e-4);  // by hand
  FloorPlan floor = floors::room({-6.0, -6.0}, {6.0, 6.0});
  // The lower arm is longer, so that the way above is the only shortest one.
  for (const Segment& wall :
       {Segment{{2.0, 2.0}, {2.0, -2.0}}, {{2.0, 2.0}, {-2.0, 2.0}}, {{2.0, -2.0}, {-3.0, -2.0}}}) {
    floor.walls.push_back(wall);
  }
  Query query{NavigationMesh(floor, CLEARANCE)};
  const auto path = query.findPath({0.0, 0.0}, {4.0, 0.0});
  ASSERT_TRUE(path);
  EXPECT_GE(path->length, lengthRoundTheU(CLOSER));
  EXPECT_LE(path->length, lengthRoundTheU(FARTHER));
  EXPECT_GE(floors::clearanceOf(floor, {0.0, 0.0}, *path), CLOSER);
}

TEST(NavigationMesh, PathRoundAnObstacleIsShortest) {
  // Two tangents to a disc and the arc between them.
  const auto length = [](double radius) {
    return 2.0 * std::sqrt(9.0 - radius * radius) + 2.0 * radius * std::asin(radius / 3.0);
  };
  EXPECT_NEAR(length(1.3), 6.5727, 1e-4);  // by hand
  FloorPlan floor = floors::room({-6.0, -6.0}, {6.0, 6.0});
  floor.obstacles = {{{0.0, 0.0}, 1.0}};
  Query query{NavigationMesh(floor, CLEARANCE)};
  const auto path = query.findPath({-3.0, 0.0}, {3.0, 0.0});
  ASSERT_TRUE(path);
  EXPECT_GE(path->length, length(1.0 + CLOSER));
  EXPECT_LE(path->length, length(1.0 + FARTHER));
}

TEST(NavigationMesh, AFloorNeedsNoWalls) {
  FloorPlan floor;
  floor.bounds = FloorPlan::Bounds{{0.0, 0.0}, {4.0, 3.0}};
  const NavigationMesh mesh(floor, CLEARANCE);
  EXPECT_EQ(mesh.componentCount(), 1U);
  Query query(mesh);
  EXPECT_TRUE(query.contains({0.01, 0.01}));  // edges of the floor are not walls
  EXPECT_FALSE(query.contains({-0.01, 0.01}));
}

TEST(NavigationMesh, AFloorWithoutRoomHasNoMesh) {
  const NavigationMesh mesh(floors::room({0.0, 0.0}, {0.5, 0.5}), CLEARANCE);
  Query query(mesh);
  EXPECT_FALSE(query.findPath({0.25, 0.25}, {0.2, 0.25}));  // in the room, which is too small
  FloorPlan crammed;
  crammed.bounds = FloorPlan::Bounds{{0.0, 0.0}, {1.0, 1.0}};
  crammed.obstacles = {{{0.5, 0.5}, 5.0}};
  const NavigationMesh none(crammed, CLEARANCE);
  EXPECT_EQ(none.componentCount(), 0U);
  EXPECT_TRUE(none.polygons().empty());
  EXPECT_FALSE(Query(none).nearestPoint({0.5, 0.5}, 100.0));
}

TEST(NavigationMesh, SameFloorSameMesh) {
  const FloorPlan floor = floors::roomWithDoor(1.0);
  const auto polygons = NavigationMesh(floor, CLEARANCE).polygons();
  EXPECT_FALSE(polygons.empty());
  EXPECT_EQ(NavigationMesh(floor, CLEARANCE).polygons(), polygons);
}

TEST(NavigationMesh, PolygonsAreConvexAndCounterclockwise) {
  for (const auto& polygon : NavigationMesh(floors::roomWithDoor(1.0), CLEARANCE).polygons()) {
    ASSERT_GE(polygon.size(), 3U);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vector2& corner = polygon[(i + 1) % polygon.size()];
      EXPECT_GE(cross(corner - polygon[i], polygon[(i + 2) % polygon.size()] - corner), -1e-9);
    }
  }
}

TEST(NavigationMesh, SmallAgentsGetSmallCellsAndLargeFloorsLargeOnes) {
  EXPECT_EQ(NavigationMesh(floors::roomWithDoor(1.0), 0.1).cellSize(), 0.025);
  EXPECT_EQ(NavigationMesh(floors::roomWithDoor(1.0), 0.3).cellSize(), NavigationMesh::DEFAULT_CELL_SIZE);
  // 300 m by 300 m in 8 million cells.
  const NavigationMesh large(floors::room({0.0, 0.0}, {292.0, 292.0}), 0.3);
  EXPECT_NEAR(large.cellSize(), std::sqrt(300.0 * 300.0 / 8e6), 1e-9);
  const auto path = Query(large).findPath({1.0, 1.0}, {291.0, 291.0});
  ASSERT_TRUE(path);
  EXPECT_NEAR(path->length, 290.0 * std::sqrt(2.0), 1e-6);
}

TEST(NavigationMesh, ManyObstaclesMakeLargerCells) {
  // More polygons than Detour can number.
  constexpr int SIDE = 60;
  FloorPlan floor;
  for (int row = 0; row < SIDE; ++row) {
    for (int column = 0; column < SIDE; ++column) {
      const double shift = 0.013 * ((7 * row + 3 * column) % 11);  // the outlines are not all the same
      floor.obstacles.push_back({{1.2 * column + shift, 1.2 * row + shift}, 0.1});
    }
  }
  const NavigationMesh mesh(floor, 0.25);
  EXPECT_GT(mesh.cellSize(), NavigationMesh::DEFAULT_CELL_SIZE);
  EXPECT_EQ(mesh.componentCount(), 1U);
  const Vector2 start(-1.0, -1.0);
  const Vector2 goal(72.0, 71.0);
  const auto path = Query(mesh).findPath(start, goal);
  ASSERT_TRUE(path);
  EXPECT_LT(path->length, 1.1 * (goal - start).norm());
  EXPECT_GE(floors::clearanceOf(floor, start, *path), 0.25 - mesh.tolerance() - 1e-6);
}

}  // namespace
}  // namespace crowd::navigation_mesh_test
