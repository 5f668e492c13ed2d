#pragma once

#include <visualization_msgs/Marker.h>

#include <vector>

#include "maps/occupancy_map.h"

namespace crowd {

/// @brief Cells of the same state that form a rectangle: `first` and the cells up to `end`, which is not included.
struct CellBlock {
  Cell first;
  Cell end;
  CellState state = CellState::FREE;
};

/// @brief Returns blocks that cover all cells of a valid map that are not free, each cell once: runs of a row, which
/// are joined with equal runs of the rows above.
std::vector<CellBlock> blocksOf(const OccupancyMap& map);

/// @brief The cells of a map that are not free: occupied ones dark, unknown ones light. @param map valid, or without
/// cells: the marker is deleted then
visualization_msgs::Marker drawMap(const OccupancyMap& map);

}  // namespace crowd
