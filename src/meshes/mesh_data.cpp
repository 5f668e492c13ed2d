#include "meshes/mesh_data.h"

#include <recastnavigation/DetourNavMeshBuilder.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <string>

#include "common/portable_math.h"
#include "common/text/numbers.h"
#include "meshes/polygon_mesh.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr double MIN_CELLS_OF_CLEARANCE = 4.0;
/// A mesh with too many polygons is built again with cells that are larger by this factor.
constexpr double COARSER = 1.5;

void checkAboveZero(const std::string& name, double value) {
  if (std::isfinite(value) && value > 0.0) return;
  throw InputError("navigation mesh: " + name + " is " + toText(value) + ", expected a number above 0 [m]");
}

/// Size of cells of which at most MAX_CELLS cover the floor [m].
double smallestCells(const FloorPlan::Bounds& bounds) {
  const Vector2 size = bounds.high - bounds.low;
  constexpr double MAX_SIDE = 65000.0;  // cells; Recast numbers them with 16 bits
  return std::max(std::sqrt(size.x()) * std::sqrt(size.y() / FloorRaster::MAX_CELLS), size.maxCoeff() / MAX_SIDE);
}

[[noreturn]] void throwTooLarge(const FloorPlan::Bounds& bounds, double clearance) {
  const Vector2 size = bounds.high - bounds.low;
  throw InputError("navigation mesh: the floor of " + toText(size.x()) + " m x " + toText(size.y()) +
                   " m is too large or has too many corners for a clearance of " + toText(clearance) +
                   " m, expected a smaller floor");
}

}  // namespace

NavigationMesh::Data::Data(const FloorPlan& plan, double clearance, double cell_size, const StopRequest& stop)
    : clearance_(clearance) {
  checkAboveZero("clearance", clearance);
  checkAboveZero("cell size", cell_size);
  const FloorPlan::Bounds bounds = plan.checkedBounds();
  origin_ = bounds.low;
  cell_size_ = std::max(std::min(cell_size, clearance / MIN_CELLS_OF_CLEARANCE), smallestCells(bounds));
  do {
    if (cell_size_ > clearance) throwTooLarge(bounds, clearance);
  } while (!build(FloorRaster(plan, bounds, clearance, cell_size_, stop), stop) && (cell_size_ *= COARSER) > 0.0);
  if (!detour_) return;
  findComponents();
  findTurningPoints();
}

/// Returns false if there are too many polygons.
bool NavigationMesh::Data::build(const FloorRaster& raster, const StopRequest& stop) {
  const FloorRegions regions(raster, stop);
  if (regions.firstCells().empty()) return true;
  const PolygonMesh polygons = buildPolygonMesh(regions, stop);
  if (!polygons) return false;
  std::fill_n(polygons->flags, polygons->npolys, std::uint16_t{1});
  dtNavMeshCreateParams params{};
  params.verts = polygons->verts;
  params.vertCount = polygons->nverts;
  params.polys = polygons->polys;
  params.polyFlags = polygons->flags;
  params.polyAreas = polygons->areas;
  params.polyCount = polygons->npolys;
  params.nvp = polygons->nvp;
  params.bmax[0] = static_cast<float>(raster.columns());
  params.bmax[1] = 1.0F;
  params.bmax[2] = static_cast<float>(raster.rows());
  params.walkableHeight = 1.0F;
  params.walkableClimb = 1.0F;
  params.cs = 1.0F;
  params.ch = 1.0F;
  unsigned char* data = nullptr;
  int size = 0;
  if (!dtCreateNavMeshData(&params, &data, &size)) throw std::bad_alloc();
  detour_.reset(dtAllocNavMesh());
  if (!detour_ || dtStatusFailed(detour_->init(data, size, DT_TILE_FREE_DATA))) {
    dtFree(data);
    throw std::bad_alloc();
  }
  tile_ = static_cast<const dtNavMesh&>(*detour_).getTile(0);
  grid_ = PolygonGrid(*tile_, raster.columns(), raster.rows());
  exits_ = PolygonExits(*tile_);
  bytes_ = static_cast<std::size_t>(size) + grid_.bytes() + exits_.bytes();
  return true;
}

void NavigationMesh::Data::findComponents() {
  const dtMeshTile& mesh = tile();
  const auto count = static_cast<std::size_t>(mesh.header->polyCount);
  constexpr Component NONE = UINT32_MAX;
  components_.assign(count, NONE);
  std::vector<std::size_t> open;
  for (std::size_t first = 0; first < count; ++first) {
    if (components_[first] != NONE) continue;
    const auto component = static_cast<Component>(component_count_++);
    components_[first] = component;
    open.push_back(first);
    while (!open.empty()) {
      const dtPoly& polygon = mesh.polys[open.back()];
      open.pop_back();
      for (std::size_t edge = 0; edge < polygon.vertCount; ++edge) {
        if (polygon.neis[edge] == 0) continue;
        const std::size_t neighbour = polygon.neis[edge] - 1U;
        if (components_[neighbour] != NONE) continue;
        components_[neighbour] = component;
        open.push_back(neighbour);
      }
    }
  }
}

void NavigationMesh::Data::findTurningPoints() {
  const dtMeshTile& mesh = tile();
  const auto count = static_cast<std::size_t>(mesh.header->vertCount);
  std::vector<double> angles(count, 0.0);  // of all polygons at a vertex
  is_turning_point_.assign(count, 0);
  for (std::size_t i = 0; i < components_.size(); ++i) {
    const dtPoly& polygon = mesh.polys[i];
    const std::size_t corners = polygon.vertCount;
    for (std::size_t k = 0; k < corners; ++k) {
      const auto position = [&](std::size_t corner) -> Vector2 {
        const float* coordinates = mesh.verts + std::size_t{3} * polygon.verts[corner % corners];
        return {coordinates[0], coordinates[2]};
      };
      const Vector2 to_last = position(k + corners - 1) - position(k);
      const Vector2 to_next = position(k + 1) - position(k);
      angles[polygon.verts[k]] += portable::atan2(std::abs(cross(to_last, to_next)), to_last.dot(to_next));
      if (polygon.neis[k] == 0) {
        is_turning_point_[polygon.verts[k]] = 1;
        is_turning_point_[polygon.verts[(k + 1) % corners]] = 1;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (angles[i] <= PI + 1e-9) is_turning_point_[i] = 0;
  }
}

NavigationMesh::NavigationMesh(const FloorPlan& plan, double clearance, double cell_size, const StopRequest& stop)
    : data_(std::make_shared<const Data>(plan, clearance, cell_size, stop)) {}

double NavigationMesh::clearance() const { return data_->clearance(); }
double NavigationMesh::cellSize() const { return data_->cellSize(); }
double NavigationMesh::tolerance() const { return FloorRaster::TOLERANCE * data_->cellSize(); }
std::size_t NavigationMesh::componentCount() const { return data_->componentCount(); }
std::size_t NavigationMesh::bytes() const {
  return data_->bytes() + data_->polygonCount() * sizeof(Component) + data_->isTurningPoint().size() + sizeof(Data);
}

std::vector<std::vector<Vector2>> NavigationMesh::polygons() const {
  std::vector<std::vector<Vector2>> polygons(data_->polygonCount());
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const dtMeshTile& mesh = data_->tile();
    for (std::size_t k = 0; k < mesh.polys[i].vertCount; ++k) {
      const float* vertex = mesh.verts + 3U * mesh.polys[i].verts[k];
      polygons[i].push_back(data_->toMetres({vertex[0], vertex[2]}));
    }
    std::reverse(polygons[i].begin(), polygons[i].end());
  }
  return polygons;
}

}  // namespace crowd
