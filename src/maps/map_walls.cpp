#include "maps/map_walls.h"

#include <cstdint>
#include <utility>

namespace crowd {
namespace {

/// Follows the boundary from row to row. Lines of cell edges are numbered like the cells above or right of them.
class WallTracer {
 public:
  explicit WallTracer(const OccupancyMap& map)
      : map_(map),
        frame_(map),
        columns_(static_cast<std::int32_t>(map.width)),
        rows_(static_cast<std::int32_t>(map.height)),
        starts_(map.width + 1, NONE) {}

  std::vector<Segment> trace() {
    for (std::int32_t row = 0; row <= rows_; ++row) {
      traceUpright(row);
      traceLevel(row);
    }
    return std::move(walls_);
  }

 private:
  static constexpr std::int32_t NONE = -1;

  /// Whether the edge between the cell and its left or lower neighbour is part of the boundary.
  bool isBoundary(const Cell& cell, const Cell& neighbour) const { return map_.isFree(cell) != map_.isFree(neighbour); }

  void add(const Cell& from, const Cell& to) { walls_.push_back({frame_.cornerOf(from), frame_.cornerOf(to)}); }

  /// Starts upright walls in this row, and ends those that do not continue in it.
  void traceUpright(std::int32_t row) {
    for (std::int32_t column = 0; column <= columns_; ++column) {
      std::int32_t& start = starts_[static_cast<std::size_t>(column)];
      const bool continues = isBoundary({column, row}, {column - 1, row});
      if (continues == (start != NONE)) continue;
      if (!continues) add({column, start}, {column, row});
      start = continues ? row : NONE;
    }
  }

  /// Adds the level walls at the lower edge of this row.
  void traceLevel(std::int32_t row) {
    std::int32_t start = NONE;
    for (std::int32_t column = 0; column <= columns_; ++column) {
      const bool continues = isBoundary({column, row}, {column, row - 1});
      if (continues == (start != NONE)) continue;
      if (!continues) add({start, row}, {column, row});
      start = continues ? column : NONE;
    }
  }

  const OccupancyMap& map_;
  CellFrame frame_;
  std::int32_t columns_;
  std::int32_t rows_;
  std::vector<std::int32_t> starts_;  // for each upright line the row in which its wall starts, or NONE
  std::vector<Segment> walls_;
};

}  // namespace

std::vector<Segment> traceWalls(const OccupancyMap& map) {
  requireValid(map);
  return WallTracer(map).trace();
}

}  // namespace crowd
