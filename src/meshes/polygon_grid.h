#pragma once

#include <recastnavigation/DetourNavMesh.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// Lists the polygons near a point with a uniform grid. All coordinates are in cells of the mesh's raster.
///
/// Detour's own search takes ten times as long (research/docs/performance_log.md).
class PolygonGrid {
 public:
  PolygonGrid() = default;
  /// @param columns, rows of the raster
  PolygonGrid(const dtMeshTile& mesh, std::size_t columns, std::size_t rows);

  /// Calls visit(polygon) for at least the polygons within a square around a point, for some of them several times,
  /// until it returns true; returns whether it did. @param reach half of the side of the square
  template <typename Visit>
  bool visitNear(const Vector2& point, double reach, const Visit& visit) const {
    for (std::size_t row = indexOf(point.y() - reach, rows_); row <= indexOf(point.y() + reach, rows_); ++row) {
      const auto first = first_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
      const std::uint32_t begin = first[static_cast<std::ptrdiff_t>(indexOf(point.x() - reach, columns_))];
      const std::uint32_t end = first[static_cast<std::ptrdiff_t>(indexOf(point.x() + reach, columns_)) + 1];
      if (std::any_of(polygons_.begin() + begin, polygons_.begin() + end, visit)) return true;
    }
    return false;
  }
  std::size_t bytes() const {
    return first_.capacity() * sizeof(std::uint32_t) + polygons_.capacity() * sizeof(std::uint16_t);
  }

 private:
  static constexpr double SIDE = 16.0;  // of a square of the grid [cells]

  /// The column or row of a coordinate, or the nearest one.
  static std::size_t indexOf(double coordinate, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(coordinate / SIDE, 0.0, static_cast<double>(count - 1)));
  }
  /// Calls visit(square) for the squares that the bounds of a polygon overlap.
  template <typename Visit>
  void visitSquares(const dtMeshTile& mesh, const dtPoly& polygon, const Visit& visit) const;

  std::size_t columns_ = 1;
  std::size_t rows_ = 1;
  std::vector<std::uint32_t> first_{0, 0};  // first_[square]: index of its first polygon
  std::vector<std::uint16_t> polygons_;     // of all squares
};

}  // namespace crowd
