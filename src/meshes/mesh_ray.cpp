#include "meshes/mesh_ray.h"

namespace crowd {
namespace {

constexpr std::size_t NONE = SIZE_MAX;

Segment edgeOf(const dtMeshTile& mesh, const dtPoly& polygon, std::size_t edge) {
  const auto vertex = [&](std::size_t number) -> Vector2 {
    const float* coordinates = mesh.verts + std::size_t{3} * polygon.verts[number];
    return {coordinates[0], coordinates[2]};
  };
  return {vertex(edge), vertex(edge + 1 < polygon.vertCount ? edge + 1 : 0)};
}

/// Distance of a point from the line of an edge, positive inside, times the length of the edge. Recast's polygons are
/// clockwise.
double insideBy(const Segment& edge, const Vector2& point) { return -cross(edge.to - edge.from, point - edge.from); }

bool isOutside(const Segment& edge, double inside_by, double tolerance) {
  return inside_by < 0.0 && inside_by < -tolerance * (edge.to - edge.from).norm();
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
    const Segment line = edgeOf(mesh, polygon, edge);
    const double end = insideBy(line, to);
    if (!isOutside(line, end, RAY_TOLERANCE)) continue;
    const double start = insideBy(line, from);
    if (end >= start) continue;
    const double share = (start + RAY_TOLERANCE * (line.to - line.from).norm()) / (start - end);
    if (exit.edge == NONE || share < exit.share) exit = {edge, share};
  }
  return exit;
}

}  // namespace

bool isOnPolygon(const NavigationMesh::Data& mesh, std::size_t polygon, const Vector2& point, double tolerance) {
  const dtPoly& shape = mesh.tile().polys[polygon];
  for (std::size_t edge = 0; edge < shape.vertCount; ++edge) {
    const Segment line = edgeOf(mesh.tile(), shape, edge);
    if (isOutside(line, insideBy(line, point), tolerance)) return false;
  }
  return true;
}

Vector2 nearestOnRim(const NavigationMesh::Data& mesh, std::size_t polygon, const Vector2& point) {
  const dtPoly& shape = mesh.tile().polys[polygon];
  Vector2 nearest = nearestPoint(edgeOf(mesh.tile(), shape, 0), point);
  for (std::size_t edge = 1; edge < shape.vertCount; ++edge) {
    const Vector2 other = nearestPoint(edgeOf(mesh.tile(), shape, edge), point);
    if ((other - point).squaredNorm() < (nearest - point).squaredNorm()) nearest = other;
  }
  return nearest;
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
