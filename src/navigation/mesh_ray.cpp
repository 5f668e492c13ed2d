#include "navigation/mesh_ray.h"

namespace crowd {
namespace {

constexpr std::size_t NONE = SIZE_MAX;

/// An edge of a polygon; the distances of the ends of a line from it, positive inside, times its length.
struct EdgeDistances {
  double start = 0.0;
  double end = 0.0;
  double tolerance = 0.0;
};

EdgeDistances distances(const dtMeshTile& mesh, const dtPoly& polygon, std::size_t edge, const Vector2& from,
                        const Vector2& to) {
  const auto vertex = [&](std::size_t number) -> Vector2 {
    const float* coordinates = mesh.verts + std::size_t{3} * polygon.verts[number % polygon.vertCount];
    return {coordinates[0], coordinates[2]};
  };
  const Vector2 corner = vertex(edge);
  const Vector2 along = vertex(edge + 1) - corner;
  // Recast's polygons are clockwise.
  return {-cross(along, from - corner), -cross(along, to - corner), RAY_TOLERANCE * along.norm()};
}

/// Where a line leaves a polygon that is larger by RAY_TOLERANCE.
struct Exit {
  std::size_t edge = NONE;  ///< NONE: it ends inside
  double share = 1.0;       ///< of the line
};

Exit exitOf(const dtMeshTile& mesh, const dtPoly& polygon, const Vector2& from, const Vector2& to,
            std::size_t came_from) {
  Exit exit;
  for (std::size_t edge = 0; edge < polygon.vertCount; ++edge) {
    if (polygon.neis[edge] == came_from + 1) continue;
    const EdgeDistances distance = distances(mesh, polygon, edge, from, to);
    if (distance.end >= -distance.tolerance || distance.end >= distance.start) continue;
    const double share = (distance.start + distance.tolerance) / (distance.start - distance.end);
    if (exit.edge == NONE || share < exit.share) exit = {edge, share};
  }
  return exit;
}

}  // namespace

bool isOnPolygon(const NavigationMesh::Data& mesh, std::size_t polygon, const Vector2& point) {
  const dtPoly& shape = mesh.tile().polys[polygon];
  for (std::size_t edge = 0; edge < shape.vertCount; ++edge) {
    const EdgeDistances distance = distances(mesh.tile(), shape, edge, point, point);
    if (distance.start < -distance.tolerance) return false;
  }
  return true;
}

double followRay(const NavigationMesh::Data& mesh, std::size_t polygon, const Vector2& from, const Vector2& to) {
  const dtMeshTile& tile = mesh.tile();
  std::size_t came_from = NONE - 1;
  // Polygons are convex, so a line passes each of them once.
  for (std::size_t i = 0; i < mesh.polygonCount(); ++i) {
    const dtPoly& current = tile.polys[polygon];
    const Exit exit = exitOf(tile, current, from, to, came_from);
    if (exit.edge == NONE) return 1.0;
    if (current.neis[exit.edge] == 0) return exit.share;
    came_from = polygon;
    polygon = current.neis[exit.edge] - std::size_t{1};
  }
  return 0.0;
}

}  // namespace crowd
