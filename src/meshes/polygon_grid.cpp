#include "meshes/polygon_grid.h"

#include <Eigen/Geometry>

namespace crowd {

PolygonGrid::PolygonGrid(const dtMeshTile& mesh, std::size_t columns, std::size_t rows)
    : columns_(columns / static_cast<std::size_t>(SIDE) + 1), rows_(rows / static_cast<std::size_t>(SIDE) + 1) {
  const auto count = static_cast<std::uint16_t>(mesh.header->polyCount);
  first_.assign(columns_ * rows_ + 2, 0);
  for (std::uint16_t i = 0; i < count; ++i) {
    visitSquares(mesh, mesh.polys[i], [&](std::size_t square) { ++first_[square + 2]; });
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  polygons_.resize(first_.back());
  // first_[square + 1] is the index of its first polygon, and advances to that of the next square.
  for (std::uint16_t i = 0; i < count; ++i) {
    visitSquares(mesh, mesh.polys[i], [&](std::size_t square) { polygons_[first_[square + 1]++] = i; });
  }
}

template <typename Visit>
void PolygonGrid::visitSquares(const dtMeshTile& mesh, const dtPoly& polygon, const Visit& visit) const {
  Eigen::AlignedBox2d bounds;
  for (std::size_t i = 0; i < polygon.vertCount; ++i) {
    const float* const vertex = mesh.verts + std::size_t{3} * polygon.verts[i];
    bounds.extend(Vector2(vertex[0], vertex[2]));
  }
  for (std::size_t row = indexOf(bounds.min().y(), rows_); row <= indexOf(bounds.max().y(), rows_); ++row) {
    for (std::size_t column = indexOf(bounds.min().x(), columns_); column <= indexOf(bounds.max().x(), columns_);
         ++column) {
      visit(row * columns_ + column);
    }
  }
}

}  // namespace crowd
