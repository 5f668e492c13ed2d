#include "meshes/floor_regions.h"

#include <algorithm>

namespace crowd {

FloorRegions::FloorRegions(const FloorRaster& raster, const StopRequest& stop)
    : width_(static_cast<std::size_t>(raster.columns()) + 2),
      labels_(width_ * (static_cast<std::size_t>(raster.rows()) + 2), BLOCKED) {
  for (int row = 0; row < raster.rows(); row += BLOCK) {
    stop.throwIfMade();
    for (int column = 0; column < raster.columns(); column += BLOCK) divideBlock(raster, {column, row});
  }
}

void FloorRegions::divideBlock(const FloorRaster& raster, Cell low) {
  const int last_row = std::min(low.row + BLOCK, raster.rows());
  const int last_column = std::min(low.column + BLOCK, raster.columns());
  runs_.clear();
  for (int row = low.row; row < last_row; ++row) {
    below_.swap(runs_);
    findRuns(raster, row, low.column, last_column);
    labelRuns(row);
  }
}

void FloorRegions::findRuns(const FloorRaster& raster, int row, int begin, int end) {
  runs_.clear();
  for (int column = begin; column < end; ++column) {
    if (!raster.isFree(column, row)) continue;
    if (runs_.empty() || runs_.back().end != column) runs_.push_back({column, column, BLOCKED, 0});
    runs_.back().end = column + 1;
  }
}

void FloorRegions::labelRuns(int row) {
  const auto overlaps = [](const Run& a, const Run& b) { return a.begin < b.end && b.begin < a.end; };
  for (Run& run : below_) {
    run.touching =
        static_cast<int>(std::count_if(runs_.begin(), runs_.end(), [&](const Run& r) { return overlaps(r, run); }));
  }
  for (Run& run : runs_) {
    const auto touches = [&](const Run& other) { return overlaps(other, run); };
    const auto only = std::find_if(below_.begin(), below_.end(), touches);
    const bool continues =
        only != below_.end() && only->touching == 1 && std::find_if(only + 1, below_.end(), touches) == below_.end();
    if (!continues) first_cells_.push_back({run.begin, row});
    run.label = continues ? only->label : static_cast<Label>(first_cells_.size());
    std::fill(labels_.begin() + static_cast<std::ptrdiff_t>(index(run.begin, row)),
              labels_.begin() + static_cast<std::ptrdiff_t>(index(run.end, row)), run.label);
  }
}

}  // namespace crowd
