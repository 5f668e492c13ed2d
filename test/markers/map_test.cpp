#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "ros/markers/marker_map.h"

namespace crowd::map_test {
namespace {

/// Rows from the bottom; `#` is occupied, `?` unknown.
OccupancyMap mapOf(const std::vector<std::string>& rows) {
  OccupancyMap map;
  map.resolution = 0.5;
  map.origin = {{10.0, 20.0}, 0.0};
  map.width = static_cast<std::uint32_t>(rows.front().size());
  map.height = static_cast<std::uint32_t>(rows.size());
  for (const std::string& row : rows) {
    for (const char cell : row) {
      map.cells.push_back(cell == '#' ? CellState::OCCUPIED : cell == '?' ? CellState::UNKNOWN : CellState::FREE);
    }
  }
  return map;
}

std::vector<std::vector<int>> columnsAndRowsOf(const OccupancyMap& map) {
  std::vector<std::vector<int>> found;
  for (const CellBlock& block : blocksOf(map)) {
    found.push_back({block.first.column, block.end.column, block.first.row, block.end.row});
  }
  return found;
}

TEST(MarkerMap, JoinsEqualRunsOfRows) {
  const std::vector<std::vector<int>> expected{{0, 2, 0, 2}, {3, 4, 0, 1}, {3, 5, 1, 2}, {0, 2, 3, 4}};
  EXPECT_EQ(columnsAndRowsOf(mapOf({"##.#.", "##.##", ".....", "##..."})), expected);
}

TEST(MarkerMap, DoesNotJoinOccupiedAndUnknownCells) {
  const std::vector<std::vector<int>> expected{{0, 1, 0, 1}, {1, 2, 0, 1}, {0, 2, 1, 2}};
  EXPECT_EQ(columnsAndRowsOf(mapOf({"#?", "??"})), expected);
}

TEST(MarkerMap, HasItsCellsAtTheirPlaces) {
  const visualization_msgs::Marker marker = drawMap(mapOf({"...", ".#."}));
  EXPECT_EQ(marker.action, visualization_msgs::Marker::ADD);
  ASSERT_EQ(marker.points.size(), 6U);  // two triangles
  double left = 1e9;
  double right = -1e9;
  double low = 1e9;
  double high = -1e9;
  for (const geometry_msgs::Point& point : marker.points) {
    left = std::min(left, point.x);
    right = std::max(right, point.x);
    low = std::min(low, point.y);
    high = std::max(high, point.y);
  }
  EXPECT_DOUBLE_EQ(left, 10.5);  // column 1 of cells of 0.5 m from 10 m on
  EXPECT_DOUBLE_EQ(right, 11.0);
  EXPECT_DOUBLE_EQ(low, 20.5);  // row 1
  EXPECT_DOUBLE_EQ(high, 21.0);
}

TEST(MarkerMap, OccupiedCellsAreDarkerThanUnknownOnes) {
  const visualization_msgs::Marker marker = drawMap(mapOf({"#?"}));
  ASSERT_EQ(marker.colors.size(), 12U);
  EXPECT_LT(marker.colors.front().r, marker.colors.back().r);
}

TEST(MarkerMap, IsDeletedWithoutCells) {
  EXPECT_EQ(drawMap({}).action, visualization_msgs::Marker::DELETE);
  EXPECT_EQ(drawMap(mapOf({"...", "..."})).action, visualization_msgs::Marker::DELETE);
}

}  // namespace
}  // namespace crowd::map_test
