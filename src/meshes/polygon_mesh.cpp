#include "meshes/polygon_mesh.h"

#include <recastnavigation/DetourNavMesh.h>
#include <recastnavigation/RecastAlloc.h>

#include <algorithm>
#include <new>
#include <vector>

#include "meshes/region_outline.h"

namespace crowd {
namespace {

/// Recast and Detour number corners with 16 bits; some values are reserved.
constexpr std::size_t MAX_CORNERS = 65000;
/// The same with 15 bits for polygons: Detour takes a neighbour with a higher number for the edge of a tile.
constexpr std::size_t MAX_POLYGONS = 0x7FFF;

struct FreeContours {
  void operator()(rcContourSet* contours) const { rcFreeContourSet(contours); }
};
using Contours = std::unique_ptr<rcContourSet, FreeContours>;

template <typename T>
T* allocate(std::size_t count) {
  void* memory = rcAlloc(sizeof(T) * count, RC_ALLOC_PERM);
  if (memory == nullptr) throw std::bad_alloc();
  return static_cast<T*>(memory);
}

/// Recast's outlines are clockwise.
void setContour(rcContour& contour, const std::vector<Corner>& outline) {
  contour = rcContour{};
  contour.area = RC_WALKABLE_AREA;
  contour.verts = allocate<int>(4 * outline.size());
  contour.nverts = static_cast<int>(outline.size());
  int* vertex = contour.verts;
  for (auto corner = outline.rbegin(); corner != outline.rend(); ++corner) {
    for (const int coordinate : {corner->x, 0, corner->y, 0}) *vertex++ = coordinate;
  }
}

/// Makes polygon meshes of a limited number of outlines each.
class MeshParts {
 public:
  void add(const std::vector<Corner>& outline) {
    if (corner_count_ + outline.size() > MAX_CORNERS) finish();
    corner_count_ += outline.size();
    outlines_.push_back(outline);
  }

  /// Null if there are too many corners or polygons.
  PolygonMesh merge() {
    finish();
    std::size_t corners = 0;
    std::size_t polygons = 0;
    std::vector<rcPolyMesh*> parts;
    for (const PolygonMesh& part : parts_) {
      corners += static_cast<std::size_t>(part->nverts);
      polygons += static_cast<std::size_t>(part->npolys);
      parts.push_back(part.get());
    }
    if (corners > MAX_CORNERS || polygons > MAX_POLYGONS) return nullptr;
    if (parts_.size() == 1) return std::move(parts_.front());
    PolygonMesh whole(rcAllocPolyMesh());
    rcContext silent(false);
    if (!whole || !rcMergePolyMeshes(&silent, parts.data(), static_cast<int>(parts.size()), *whole)) {
      throw std::bad_alloc();
    }
    return whole;
  }

 private:
  void finish() {
    if (outlines_.empty()) return;
    const Contours contours(rcAllocContourSet());
    if (!contours) throw std::bad_alloc();
    contours->conts = allocate<rcContour>(outlines_.size());
    contours->cs = 1.0F;
    contours->ch = 1.0F;
    for (const std::vector<Corner>& outline : outlines_) setContour(contours->conts[contours->nconts++], outline);
    PolygonMesh part(rcAllocPolyMesh());
    rcContext silent(false);
    if (!part || !rcBuildPolyMesh(&silent, *contours, DT_VERTS_PER_POLYGON, *part)) throw std::bad_alloc();
    parts_.push_back(std::move(part));
    outlines_.clear();
    corner_count_ = 0;
  }

  std::vector<std::vector<Corner>> outlines_;
  std::size_t corner_count_ = 0;
  std::vector<PolygonMesh> parts_;
};

}  // namespace

PolygonMesh buildPolygonMesh(const FloorRegions& regions, const StopRequest& stop) {
  RegionOutliner outliner(regions);
  MeshParts parts;
  for (const FloorRegions::Cell& first : regions.firstCells()) {
    stop.throwIfMade();
    parts.add(outliner.outline(first));
  }
  return parts.merge();
}

}  // namespace crowd
