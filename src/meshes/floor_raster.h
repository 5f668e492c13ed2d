#pragma once

#include <cstdint>
#include <vector>

#include "common/stop_request.h"
#include "maps/floor_plan.h"

namespace crowd {

/// Square cells of a floor. A cell is free if its centre is far enough from all walls and obstacles.
class FloorRaster {
 public:
  /// Distance from walls and obstacles that is required of the centre of a free cell, beyond the clearance [cells].
  ///
  /// A passage of `clearance` on both sides and 2 cells more leaves 2 - 2 * EXTRA = 1.42 cells for the centres: enough
  /// for cells that are connected by their sides, in any direction, for which sqrt(2) is needed.
  static constexpr double EXTRA = 0.29;
  /// By how much a point of a free cell may be closer to a wall than the clearance [cells]: half a diagonal less EXTRA.
  static constexpr double TOLERANCE = 0.7072 - EXTRA;
  static constexpr double MAX_CELLS = 8e6;

  /// The plan must have been checked. @param clearance [m], above 0 @param cell_size [m]
  FloorRaster(const FloorPlan& plan, const FloorPlan::Bounds& bounds, double clearance, double cell_size,
              const StopRequest& stop);

  const Vector2& origin() const { return origin_; }  ///< lower left corner [m]
  double cellSize() const { return cell_size_; }     ///< [m]
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool isFree(int column, int row) const { return free_[index(column, row)] != 0; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  /// Blocks the cells whose centres are closer to the segment. @param distance [cells] @param piece in cells
  void block(const Segment& piece, double distance);

  Vector2 origin_;
  double cell_size_;
  int columns_;
  int rows_;
  std::vector<std::uint8_t> free_;
};

}  // namespace crowd
