#pragma once

#include <recastnavigation/DetourNavMesh.h>

#include <memory>
#include <vector>

#include "meshes/floor_raster.h"
#include "meshes/navigation_mesh.h"
#include "meshes/polygon_exits.h"
#include "meshes/polygon_grid.h"

namespace crowd {

/// The content of a NavigationMesh. Detour's x and z are the columns and rows of the raster [cells]; its y is 0.
class NavigationMesh::Data {
 public:
  /// @throws InputError and Stopped as NavigationMesh does
  Data(const FloorPlan& plan, double clearance, double cell_size, const StopRequest& stop);

  double clearance() const { return clearance_; }
  double cellSize() const { return cell_size_; }
  /// The polygons; only if there are any.
  const dtMeshTile& tile() const { return *tile_; }
  const PolygonGrid& grid() const { return grid_; }
  const PolygonExits& exits() const { return exits_; }
  std::size_t polygonCount() const { return components_.size(); }
  /// The component of each polygon.
  const std::vector<Component>& components() const { return components_; }
  std::size_t componentCount() const { return component_count_; }
  /// Whether shortest paths can turn at a vertex: a corner of the mesh that sticks out into it. One for each vertex.
  const std::vector<std::uint8_t>& isTurningPoint() const { return is_turning_point_; }
  std::size_t bytes() const { return bytes_; }

  Vector2 toCells(const Vector2& point) const { return (point - origin_) / cell_size_; }
  Vector2 toMetres(const Vector2& cells) const { return origin_ + cell_size_ * cells; }

 private:
  struct FreeDetour {
    void operator()(dtNavMesh* mesh) const { dtFreeNavMesh(mesh); }
  };

  bool build(const FloorRaster& raster, const StopRequest& stop);
  void findComponents();
  void findTurningPoints();

  double clearance_ = 0.0;
  double cell_size_ = 0.0;
  Vector2 origin_ = Vector2::Zero();
  std::unique_ptr<dtNavMesh, FreeDetour> detour_;  // null if there is nowhere to walk
  const dtMeshTile* tile_ = nullptr;               // of it
  PolygonGrid grid_;
  PolygonExits exits_;
  std::vector<Component> components_;
  std::size_t component_count_ = 0;
  std::vector<std::uint8_t> is_turning_point_;
  std::size_t bytes_ = 0;
};

}  // namespace crowd
