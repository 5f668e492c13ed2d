#pragma once

#include <recastnavigation/Recast.h>

#include <memory>

#include "meshes/floor_regions.h"

namespace crowd {

struct FreePolyMesh {
  void operator()(rcPolyMesh* mesh) const { rcFreePolyMesh(mesh); }
};
/// Recast's mesh of convex polygons; x and z of its corners are columns and rows of the raster.
using PolygonMesh = std::unique_ptr<rcPolyMesh, FreePolyMesh>;

/// Makes convex polygons of the free cells. Null if there are too many polygons for Recast.
PolygonMesh buildPolygonMesh(const FloorRegions& regions, const StopRequest& stop);

}  // namespace crowd
