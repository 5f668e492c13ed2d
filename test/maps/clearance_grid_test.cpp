#include "maps/clearance_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "support/floors.h"
#include "support/seeds.h"

namespace crowd::clearance_grid_test {
namespace {

using Index = ClearanceGrid::Index;

TEST(ClearanceGrid, DistancesOfAWallAndADisc) {
  FloorPlan floor;
  floor.walls = {{{0.0, 0.0}, {4.0, 0.0}}};
  floor.obstacles = {{{2.0, 2.0}, 0.5}};
  const ClearanceGrid grid(floor, 0.25, 1.0);
  const auto at = [&](double x, double y) { return grid[grid.nearest({x, y})]; };
  EXPECT_NEAR(at(1.0, 0.0), 0.0, 1e-6);
  EXPECT_NEAR(at(1.0, -0.75), 0.75, 1e-6);
  EXPECT_NEAR(at(4.5, 0.0), 0.5, 1e-6);    // beyond the wall's end
  EXPECT_NEAR(at(2.0, 1.25), 0.25, 1e-6);  // between wall and disc, the disc is nearer
  EXPECT_NEAR(at(2.0, 2.0), -0.5, 1e-6);   // inside the disc
  EXPECT_NEAR(at(-1.5, -1.5), 1.0, 1e-6);  // the limit
}

TEST(ClearanceGrid, AnEmptyFloorHasNoPoints) {
  const ClearanceGrid grid(FloorPlan(), 0.1, 1.0);
  EXPECT_EQ(grid.size(), 0U);
  EXPECT_EQ(grid.nearest({0.0, 0.0}), ClearanceGrid::OUTSIDE);
}

TEST(ClearanceGrid, DistancesAreThoseToTheNearestThing) {
  forSeeds(20, KeyedRandom::CONTENT, [](std::uint64_t /*seed*/, KeyedRandom& random) {
    const FloorPlan floor = floors::random(random);
    const double limit = random.uniform(0.2, 1.5);
    const ClearanceGrid grid(floor, random.uniform(0.04, 0.2), limit);
    for (Index point = 0; point < grid.size(); ++point) {
      ASSERT_NEAR(grid[point], std::min(limit, floors::clearanceAt(floor, grid.place(point))), 1e-5);
      ASSERT_EQ(grid.nearest(grid.place(point)), point);
    }
  });
}

TEST(ClearanceGrid, CoversAMarginOfTwiceTheLimit) {
  const ClearanceGrid grid(floors::room({0.0, 0.0}, {3.0, 2.0}), 0.1, 0.5);
  EXPECT_NE(grid.nearest({-1.0, -1.0}), ClearanceGrid::OUTSIDE);
  EXPECT_NE(grid.nearest({4.0, 3.0}), ClearanceGrid::OUTSIDE);
  EXPECT_EQ(grid.nearest({-3.0, 1.0}), ClearanceGrid::OUTSIDE);
  EXPECT_EQ(grid.nearest({1.0, 6.0}), ClearanceGrid::OUTSIDE);
  EXPECT_EQ(grid.nearest({std::numeric_limits<double>::quiet_NaN(), 1.0}), ClearanceGrid::OUTSIDE);
}

TEST(ClearanceGrid, LargeFloorsHaveALargerSpacing) {
  const ClearanceGrid grid(floors::room({0.0, 0.0}, {1000.0, 1000.0}), 0.05, 0.5);
  EXPECT_LE(grid.size(), ClearanceGrid::MAX_POINTS * 1.01);
  EXPECT_NEAR(grid.spacing(), 0.25, 0.01);  // a million m2 by 16 million points
}

TEST(ClearanceGrid, NeighboursAndOffsets) {
  const ClearanceGrid grid(floors::room({0.0, 0.0}, {1.0, 1.0}), 0.5, 0.5);
  const auto neighbours = [&](Index point) {
    std::vector<Index> found;
    grid.forNeighbours(point, [&](Index at) { found.push_back(at); });
    return found;
  };
  const Index columns = grid.columns();
  EXPECT_EQ(neighbours(0), (std::vector<Index>{1, columns, columns + 1}));
  EXPECT_EQ(neighbours(columns + 1).size(), 8U);
  EXPECT_EQ(neighbours(static_cast<Index>(grid.size()) - 1).size(), 3U);
  EXPECT_EQ(grid.offset(columns + 1, -1, -1), 0U);
  EXPECT_EQ(grid.offset(0, -1, 0), ClearanceGrid::OUTSIDE);
  EXPECT_EQ(grid.offset(columns - 1, 1, 0), ClearanceGrid::OUTSIDE);
  std::vector<Index> within;
  grid.forPointsWithin(0.5, columns + 1, [&](Index at) { within.push_back(at); });
  EXPECT_EQ(within, (std::vector<Index>{1, columns, columns + 1, columns + 2, 2 * columns + 1}));
}

}  // namespace
}  // namespace crowd::clearance_grid_test
