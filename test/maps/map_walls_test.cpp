#include "maps/map_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/maps.h"

namespace crowd::map_walls_test {
namespace {

using Rows = std::vector<std::string>;
/// Walls as x1, y1, x2, y2.
using Numbers = std::vector<std::vector<double>>;

Numbers numbersOf(const std::vector<Segment>& walls) {
  Numbers numbers;
  for (const Segment& wall : walls) numbers.push_back({wall.from.x(), wall.from.y(), wall.to.x(), wall.to.y()});
  return numbers;
}

Numbers wallsOf(const Rows& rows) { return numbersOf(traceWalls(maps::drawn(rows))); }

TEST(MapWalls, FreeMapHasWallsAtItsOuterEdge) {
  EXPECT_EQ(wallsOf({"...", "...", "..."}), (Numbers{{0, 0, 3, 0}, {0, 0, 0, 3}, {3, 0, 3, 3}, {0, 3, 3, 3}}));
}

TEST(MapWalls, MapWithoutFreeCellsHasNoWalls) {
  EXPECT_TRUE(wallsOf({"###", "#?#", "???"}).empty());
  EXPECT_TRUE(wallsOf({"?"}).empty());
}

TEST(MapWalls, SingleFreeCellHasFourWalls) {
  EXPECT_EQ(wallsOf({"###", "#.#", "???"}), (Numbers{{1, 1, 2, 1}, {1, 1, 1, 2}, {2, 1, 2, 2}, {1, 2, 2, 2}}));
}

TEST(MapWalls, OccupiedCellHasFourWallsWithinTheOuterEdge) {
  EXPECT_EQ(wallsOf({"...", ".#.", "..."}), (Numbers{{0, 0, 3, 0},
                                                     {1, 1, 2, 1},
                                                     {1, 1, 1, 2},
                                                     {2, 1, 2, 2},
                                                     {1, 2, 2, 2},
                                                     {0, 0, 0, 3},
                                                     {3, 0, 3, 3},
                                                     {0, 3, 3, 3}}));
}

TEST(MapWalls, WallsSeparateFreeCellsFromUnknownAndOccupiedOnesOnly) {
  EXPECT_EQ(wallsOf({"?##", "??#", ".??"}), (Numbers{{0, 0, 1, 0}, {0, 0, 0, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}}));
}

TEST(MapWalls, StraightWallContinuesWhereTheFreeSideChanges) {
  // The lines between the two columns and between the two rows are boundary all along.
  EXPECT_EQ(wallsOf({"#.", ".#"}), (Numbers{{0, 0, 1, 0},     // below the free cell at the bottom
                                            {0, 0, 0, 1},     // left of it
                                            {0, 1, 2, 1},     // between the rows
                                            {1, 0, 1, 2},     // between the columns
                                            {2, 1, 2, 2},     // right of the free cell at the top
                                            {1, 2, 2, 2}}));  // above it
}

TEST(MapWalls, DependOnOriginYawAndResolution) {
  const std::vector<Segment> walls = traceWalls(maps::drawn({"#.#"}, 0.5, {{10.0, 20.0}, PI / 2.0}));
  ASSERT_EQ(walls.size(), 4U);
  // The free cell is 0.5 m to 1 m along +y, and its row 0.5 m wide along -x.
  EXPECT_TRUE(walls[0].from.isApprox(Vector2(10.0, 20.5)) && walls[0].to.isApprox(Vector2(10.0, 21.0)));
  EXPECT_TRUE(walls[1].from.isApprox(Vector2(10.0, 20.5)) && walls[1].to.isApprox(Vector2(9.5, 20.5)));
  EXPECT_TRUE(walls[2].from.isApprox(Vector2(10.0, 21.0)) && walls[2].to.isApprox(Vector2(9.5, 21.0)));
  EXPECT_TRUE(walls[3].from.isApprox(Vector2(9.5, 20.5)) && walls[3].to.isApprox(Vector2(9.5, 21.0)));
}

TEST(MapWalls, InvalidMapIsRefused) {
  OccupancyMap map = maps::drawn({"..."});
  map.resolution = 0.0;
  EXPECT_TRUE(contains(errorOf<InputError>([&] { traceWalls(map); }), "resolution: expected"));
}

/// An edge of a cell: its lower left end and its direction.
struct Edge {
  Cell start;
  bool is_upright;
};
bool operator==(const Edge& a, const Edge& b) { return a.start == b.start && a.is_upright == b.is_upright; }
bool operator<(const Edge& a, const Edge& b) {
  return std::make_pair(std::make_pair(a.start.row, a.start.column), a.is_upright) <
         std::make_pair(std::make_pair(b.start.row, b.start.column), b.is_upright);
}
using EdgeCounts = std::map<Edge, int>;

/// All edges between a free cell and a cell that is not free; a reference that checks each cell.
EdgeCounts boundaryOf(const OccupancyMap& map) {
  EdgeCounts edges;
  for (std::int32_t row = 0; row < static_cast<std::int32_t>(map.height); ++row) {
    for (std::int32_t column = 0; column < static_cast<std::int32_t>(map.width); ++column) {
      if (!map.isFree({column, row})) continue;
      if (!map.isFree({column - 1, row})) ++edges[{{column, row}, true}];
      if (!map.isFree({column + 1, row})) ++edges[{{column + 1, row}, true}];
      if (!map.isFree({column, row - 1})) ++edges[{{column, row}, false}];
      if (!map.isFree({column, row + 1})) ++edges[{{column, row + 1}, false}];
    }
  }
  return edges;
}

Cell roundedCell(const Vector2& cells) {
  return {static_cast<std::int32_t>(std::lround(cells.x())), static_cast<std::int32_t>(std::lround(cells.y()))};
}

/// Requires that a wall ends at corners of cells, and counts the edges that it covers.
void countEdges(const Segment& wall, const CellFrame& frame, EdgeCounts& covered) {
  Cell from = roundedCell(frame.toCells(wall.from));
  const Cell to = roundedCell(frame.toCells(wall.to));
  EXPECT_LT((frame.cornerOf(from) - wall.from).norm(), 1e-9);
  EXPECT_LT((frame.cornerOf(to) - wall.to).norm(), 1e-9);
  const bool is_upright = from.column == to.column;
  ASSERT_TRUE(is_upright ? from.row < to.row : from.row == to.row && from.column < to.column);
  for (std::int32_t& place = is_upright ? from.row : from.column; from != to; ++place) ++covered[{from, is_upright}];
}

/// Whether a wall continues another one, so that both should be one wall.
bool areMergeable(const Segment& a, const Segment& b) {
  const double turn = cross((a.to - a.from).normalized(), (b.to - b.from).normalized());
  return (a.to - b.from).norm() < 1e-9 && std::abs(turn) < 1e-9;
}

TEST(MapWalls, CoverEachEdgeOnceAndAreMaximal) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::CONTENT, {});
    const OccupancyMap map = maps::random(random, 12);
    const std::vector<Segment> walls = traceWalls(map);
    const EdgeCounts boundary = boundaryOf(map);
    EdgeCounts covered;
    double length = 0.0;
    for (const Segment& wall : walls) {
      countEdges(wall, CellFrame(map), covered);
      length += (wall.to - wall.from).norm();
      for (const Segment& other : walls) EXPECT_FALSE(areMergeable(wall, other));
    }
    EXPECT_TRUE(covered == boundary);
    EXPECT_NEAR(length, static_cast<double>(boundary.size()) * map.resolution, 1e-9);
  }
}

/// Distance from a point to the nearest cell that is not free, inside or outside of the map, at most `limit` [m].
double distanceToBlocked(const OccupancyMap& map, const Vector2& point, double limit) {
  const Vector2 at = CellFrame(map).toCells(point);
  const auto reach = static_cast<std::int32_t>(limit / map.resolution) + 1;
  const Cell middle = CellFrame(map).cellAt(point);
  double nearest = limit;
  for (std::int32_t row = middle.row - reach; row <= middle.row + reach; ++row) {
    for (std::int32_t column = middle.column - reach; column <= middle.column + reach; ++column) {
      if (map.isFree({column, row})) continue;
      const Vector2 low(column, row);
      const Vector2 inside = at.cwiseMax(low).cwiseMin(low + Vector2(1.0, 1.0));
      nearest = std::min(nearest, (inside - at).norm() * map.resolution);
    }
  }
  return nearest;
}

TEST(MapWalls, AreAsNearAsTheNearestCellThatIsNotFree) {
  int points = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::CONTENT, {1});
    const OccupancyMap map = maps::random(random, 12);
    const std::vector<Segment> walls = traceWalls(map);
    for (int i = 0; i < 20; ++i) {
      const Vector2 cells(random.uniform(0.0, map.width), random.uniform(0.0, map.height));
      const Vector2 point = CellFrame(map).toMap(cells);
      if (!map.isFree(CellFrame(map).cellAt(point))) continue;
      double nearest = 3.0 * map.resolution;
      for (const Segment& wall : walls) nearest = std::min(nearest, distanceTo(wall, point));
      EXPECT_NEAR(nearest, distanceToBlocked(map, point, 3.0 * map.resolution), 1e-9);
      ++points;
    }
  }
  EXPECT_GT(points, 300);
}

}  // namespace
}  // namespace crowd::map_walls_test
