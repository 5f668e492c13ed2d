#include "meshes/polygon_exits.h"

#include <algorithm>
#include <utility>

namespace crowd {

/// State of the depth-first search.
struct PolygonExits::Visits {
  struct Visit {
    std::size_t polygon = 0;
    std::size_t edge = 0;  // the next one to look behind
  };
  static constexpr std::size_t NONE = SIZE_MAX;

  explicit Visits(std::size_t polygons) : parents(polygons, NONE), lowest(polygons, 0), is_numbered(polygons, false) {}

  std::vector<Visit> open;
  std::vector<std::size_t> parents;
  std::vector<Number> lowest;  // number of a polygon that is next to one of the subtree
  std::vector<bool> is_numbered;
  Number count = 0;
};

PolygonExits::PolygonExits(const dtMeshTile& mesh) {
  const auto polygons = static_cast<std::size_t>(mesh.header->polyCount);
  numbers_.resize(polygons);
  exits_.resize(polygons);
  Visits visits(polygons);
  for (std::size_t i = 0; i < polygons; ++i) {
    if (!visits.is_numbered[i]) visitComponent(mesh, i, visits);
  }
}

void PolygonExits::visitComponent(const dtMeshTile& mesh, std::size_t first, Visits& visits) {
  const auto enter = [&](std::size_t polygon) {
    visits.is_numbered[polygon] = true;
    numbers_[polygon] = visits.lowest[polygon] = visits.count++;
    visits.open.push_back({polygon, 0});
  };
  /// All polygons of its subtree have been visited.
  const auto leave = [&](std::size_t polygon) {
    const std::size_t parent = visits.parents[polygon];
    if (parent == Visits::NONE) return;
    visits.lowest[parent] = std::min(visits.lowest[parent], visits.lowest[polygon]);
    if (visits.lowest[polygon] < numbers_[parent]) return;
    const Range subtree{numbers_[polygon], static_cast<Number>(visits.count - 1)};
    const dtPoly& shape = mesh.polys[parent];
    for (std::size_t edge = 0; edge < shape.vertCount; ++edge) {
      if (shape.neis[edge] == 0) continue;
      const std::size_t behind = shape.neis[edge] - 1U;
      if (visits.is_numbered[behind] && subtree.contains(numbers_[behind])) exits_[parent][edge] = subtree;
    }
  };
  enter(first);
  while (!visits.open.empty()) {
    Visits::Visit& visit = visits.open.back();
    const std::size_t polygon = visit.polygon;
    const dtPoly& shape = mesh.polys[polygon];
    if (visit.edge == shape.vertCount) {
      visits.open.pop_back();
      leave(polygon);
      continue;
    }
    const std::size_t neighbour = shape.neis[visit.edge++];
    if (neighbour == 0) continue;
    if (visits.is_numbered[neighbour - 1]) {
      visits.lowest[polygon] = std::min(visits.lowest[polygon], numbers_[neighbour - 1]);
    } else {
      visits.parents[neighbour - 1] = polygon;
      enter(neighbour - 1);
    }
  }
}

}  // namespace crowd
