#pragma once

#include <vector>

#include "geometry/geometry.h"
#include "maps/occupancy_map.h"

namespace crowd {

/// @brief The boundary between free cells and all others as walls [m], in `map`.
///
/// All cells outside of the map count as not free. A wall is a straight line along edges of cells, as long as possible;
/// each edge between a free cell and one that is not free is part of exactly one wall. So a disc whose centre is in a
/// free cell overlaps a cell that is not free only if it overlaps a wall.
///
/// Walls are sorted by the row in which they end, so that near walls are near each other in the list.
/// @throws InputError if the map is not valid
std::vector<Segment> traceWalls(const OccupancyMap& map);

}  // namespace crowd
