#include "geometry/neighbour_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "support/neighbour_grids.h"

namespace crowd::neighbour_grid_test {
namespace {

using neighbour_grids::Disc;
using neighbour_grids::find;
using neighbour_grids::Found;
using neighbour_grids::gridOf;
using neighbour_grids::sorted;

TEST(NeighbourGrid, EmptyGridFindsNothing) {
  EXPECT_TRUE(find(gridOf({}, 2.0), {0.0, 0.0}, 1e9).empty());
  EXPECT_TRUE(find(NeighbourGrid(), {0.0, 0.0}, 1e9).empty());
}

TEST(NeighbourGrid, MeasuresDistancesToTheRim) {
  const NeighbourGrid grid = gridOf({{{3.0, 4.0}, 1.0, 42}}, 2.0);
  EXPECT_EQ(find(grid, {0.0, 0.0}, 4.0), Found{42});
  EXPECT_TRUE(find(grid, {0.0, 0.0}, 3.999999).empty());
  EXPECT_EQ(find(grid, {3.5, 4.0}, 0.0), Found{42});  // inside
}

TEST(NeighbourGrid, NegativeDistanceIsADepthWithinTheDisc) {
  const NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.25, 42}}, 2.0);
  EXPECT_EQ(find(grid, {0.125, 0.0}, -0.125), Found{42});
  EXPECT_TRUE(find(grid, {0.126, 0.0}, -0.125).empty());
  EXPECT_TRUE(find(grid, {0.01, 0.0}, -0.3).empty());  // no point is as deep in this disc
}

TEST(NeighbourGrid, FindsLargeDiscsFarFromTheirCells) {
  const NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.1, 1}, {{50.0, 50.0}, 60.0, 2}, {{99.0, 99.0}, 0.1, 3}}, 1.0);
  EXPECT_EQ(find(grid, {8.0, 8.0}, 1.0), Found{2});
  EXPECT_EQ(find(grid, {92.0, 8.0}, 1.0), Found{2});
  EXPECT_TRUE(find(grid, {5.0, 5.0}, 1.0).empty());  // 63.6 m from the centre
}

TEST(NeighbourGrid, AppendsToTheList) {
  const NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.5, 5}}, 2.0);
  Found found = {9};
  grid.findNear({0.0, 0.0}, 1.0, found);
  EXPECT_EQ(found, (Found{9, 5}));
}

TEST(NeighbourGrid, FindsMovedDiscsAtTheirNewPositions) {
  NeighbourGrid grid = gridOf({{{0.0, 0.0}, 0.5, 5}, {{9.0, 0.0}, 0.5, 6}}, 2.0);
  grid.move(1, {-2.0, 1.0}, {0.5, -0.25});
  grid.update();
  EXPECT_EQ(find(grid, {-2.0, 3.0}, 1.5), Found{6});
  EXPECT_TRUE(find(grid, {9.0, 0.0}, 1.0).empty());
  EXPECT_EQ(find(grid, {0.0, 0.0}, 1.0), Found{5});
  EXPECT_EQ(grid.velocity(0), Vector2(0.0, 0.0));
  EXPECT_EQ(grid.velocity(1), Vector2(0.5, -0.25));
}

TEST(NeighbourGrid, FindsManyDiscsMovedOneAfterTheOther) {
  for (const std::uint32_t count : {32U, 33U, 100U}) {
    SCOPED_TRACE(count);
    std::vector<Disc> discs;
    for (std::uint32_t i = 0; i < count; ++i) discs.push_back({{1000.0 - 3.0 * i, 0.0}, 0.5, i});
    NeighbourGrid grid = gridOf(discs, 2.0);
    for (std::uint32_t i = 0; i < count; ++i) {
      const Vector2 before = discs[i].centre;
      const Vector2 after(-3.0 * i, 50.0);
      EXPECT_TRUE(grid.isAnyNear(before, 0.1, UINT32_MAX));
      grid.move(i, after, Vector2::Zero());
      grid.update();
      EXPECT_FALSE(grid.isAnyNear(before, 0.1, UINT32_MAX));
      EXPECT_TRUE(grid.isAnyNear(after, 0.1, UINT32_MAX));
      EXPECT_FALSE(grid.isAnyNear(after, 0.1, i));
      EXPECT_EQ(find(grid, after, 0.1), Found{i});
    }
  }
}

TEST(NeighbourGrid, FindsDiscsInAHugeExtentAlongOneAxis) {
  for (const Vector2& unit : {Vector2(1.0, 0.0), Vector2(0.0, 1.0)}) {
    std::vector<Disc> discs;
    for (std::uint32_t i = 0; i < 40; ++i) discs.push_back({std::pow(10.0, i) * unit, 0.5, i});
    const NeighbourGrid grid = gridOf(discs, 2.0);
    EXPECT_EQ(sorted(find(grid, 0.5 * unit, 10.0)), (Found{0, 1}));
    EXPECT_EQ(find(grid, 1e19 * unit, 1e17), Found{19});
  }
}

TEST(NeighbourGrid, FindsDiscsBesideAnExtremeOutlier) {
  std::vector<Disc> discs(40, {{50.0, 50.0}, 0.5, 4});
  discs.insert(discs.end(), {{{0.0, 0.0}, 0.5, 1}, {{1.0, 0.0}, 0.5, 2}, {{1e300, -1e300}, 0.5, 3}});
  const NeighbourGrid grid = gridOf(discs, 2.0);
  EXPECT_EQ(sorted(find(grid, {0.0, 0.0}, 6.0)), (Found{1, 2}));
}

TEST(NeighbourGrid, FindsDiscsAtTheSamePosition) {
  const std::vector<Disc> discs(100, {{1.0, 2.0}, 0.25, 4});
  EXPECT_EQ(find(gridOf(discs, 2.0), {1.0, 3.0}, 0.75), Found(100, 4));
  EXPECT_TRUE(find(gridOf(discs, 2.0), {1.0, 3.0}, 0.74).empty());
}

}  // namespace
}  // namespace crowd::neighbour_grid_test
