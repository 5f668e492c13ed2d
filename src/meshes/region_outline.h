#pragma once

#include <vector>

#include "meshes/floor_regions.h"

namespace crowd {

/// A corner of the raster.
struct Corner {
  int x = 0;
  int y = 0;
  bool operator==(const Corner& other) const { return x == other.x && y == other.y; }
};

/// Finds the outlines of regions as simple polygons, counterclockwise, with few corners.
///
/// Neighbouring regions have all corners along their common border in common. Along blocked cells, steps are cut off
/// on the inner side: a polygon never contains a point outside its region.
class RegionOutliner {
 public:
  explicit RegionOutliner(const FloorRegions& regions) : regions_(regions) {}

  /// @param first cell of the region, see FloorRegions::firstCells()
  /// @return valid until the next call
  const std::vector<Corner>& outline(FloorRegions::Cell first);

 private:
  /// A corner, and the regions at the edges before and behind it.
  struct Step {
    Corner corner;
    FloorRegions::Label before = FloorRegions::BLOCKED;
    FloorRegions::Label behind = FloorRegions::BLOCKED;
    /// Whether neighbouring regions have this corner, too, or may have it.
    bool isShared() const { return before != FloorRegions::BLOCKED || behind != FloorRegions::BLOCKED; }
  };

  void trace(FloorRegions::Cell first);
  void simplify();
  std::size_t farthest(std::size_t from) const;
  bool isSimple() const;

  const FloorRegions& regions_;
  std::vector<Step> steps_;
  std::vector<Corner> outline_;
};

}  // namespace crowd
