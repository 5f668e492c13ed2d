#include "ros/markers/marker_map.h"

#include <map>
#include <utility>

#include "ros/markers/marker_shapes.h"

namespace crowd {
namespace {

/// Indices of the blocks that end at a row, by their columns.
using OpenBlocks = std::map<std::pair<std::int32_t, std::int32_t>, std::size_t>;

/// The column behind the run of equal cells that begins at a cell.
std::int32_t endOfRun(const OccupancyMap& map, Cell cell) {
  const CellState state = map.cells[map.indexOf(cell)];
  while (map.contains(cell) && map.cells[map.indexOf(cell)] == state) ++cell.column;
  return cell.column;
}

}  // namespace

std::vector<CellBlock> blocksOf(const OccupancyMap& map) {
  std::vector<CellBlock> blocks;
  OpenBlocks below;
  for (Cell cell; map.contains({0, cell.row}); ++cell.row) {
    OpenBlocks open;
    for (cell.column = 0; map.contains(cell);) {
      const CellState state = map.cells[map.indexOf(cell)];
      const std::int32_t end = endOfRun(map, cell);
      const auto same = below.find({cell.column, end});
      if (state != CellState::FREE && same != below.end() && blocks[same->second].state == state) {
        ++blocks[same->second].end.row;
        open.insert(*same);
      } else if (state != CellState::FREE) {
        open[{cell.column, end}] = blocks.size();
        blocks.push_back({cell, {end, cell.row + 1}, state});
      }
      cell.column = end;
    }
    below = std::move(open);
  }
  return blocks;
}

visualization_msgs::Marker drawMap(const OccupancyMap& map) {
  TriangleMarker marker(marker_style::MAP, 0, marker_style::Layer::MAP);
  if (map.cells.empty()) return marker.finish();
  const CellFrame frame(map);
  for (const CellBlock& block : blocksOf(map)) {
    const Vector2 a = frame.cornerOf(block.first);
    const Vector2 b = frame.cornerOf({block.end.column, block.first.row});
    const Vector2 c = frame.cornerOf(block.end);
    const Vector2 d = frame.cornerOf({block.first.column, block.end.row});
    const marker_style::Colour colour = marker_style::ofCell(block.state == CellState::OCCUPIED);
    marker.addTriangle(a, b, c, colour);
    marker.addTriangle(a, c, d, colour);
  }
  return marker.finish();
}

}  // namespace crowd
