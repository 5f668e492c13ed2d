#pragma once

#include <cstdint>
#include <vector>

#include "meshes/floor_raster.h"

namespace crowd {

/// Partition of the free cells into regions without holes, which become polygons.
///
/// The floor is divided into square blocks; the free cells of a block into regions that have one run of cells in each
/// of their rows, which overlaps the runs in the rows above and below. So two regions touch each other along straight
/// lines of the raster only.
class FloorRegions {
 public:
  using Label = std::uint32_t;
  static constexpr Label BLOCKED = 0;
  static constexpr int BLOCK = 64;  // [cells]

  /// A cell.
  struct Cell {
    int column = 0;
    int row = 0;
  };

  FloorRegions(const FloorRaster& raster, const StopRequest& stop);

  /// The region of a cell, or BLOCKED; also for the cells around the floor, from -1 to the number of columns or rows.
  Label at(int column, int row) const { return labels_[index(column, row)]; }
  /// The leftmost cell in the lowest row of each region; the region's label is its index + 1.
  const std::vector<Cell>& firstCells() const { return first_cells_; }

 private:
  /// Free cells next to each other in a row of a block.
  struct Run {
    int begin = 0;
    int end = 0;
    Label label = BLOCKED;
    int touching = 0;  // runs in the next row
  };

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row + 1) * width_ + static_cast<std::size_t>(column + 1);
  }
  void divideBlock(const FloorRaster& raster, Cell low);
  void findRuns(const FloorRaster& raster, int row, int begin, int end);
  void labelRuns(int row);

  std::size_t width_;  // of a row, with the cells around the floor
  std::vector<Label> labels_;
  std::vector<Cell> first_cells_;
  std::vector<Run> below_;  // runs of the last row
  std::vector<Run> runs_;   // runs of this row
};

}  // namespace crowd
