#pragma once

#include <recastnavigation/DetourNavMesh.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace crowd {

/// @brief Tells through which edges of a polygon a path can lead to a goal: not into a room with one door, unless the
/// goal is in it.
///
/// The parts of a mesh that a polygon separates from each other are subtrees of a depth-first search tree (Hopcroft and
/// Tarjan 1973), so each is a range of the numbers in which the search enters polygons. Immutable.
class PolygonExits {
 public:
  PolygonExits() = default;
  explicit PolygonExits(const dtMeshTile& mesh);

  /// @brief Whether a path can lead from a polygon through an edge of it to another polygon of the same component,
  /// without coming back to the polygon.
  bool doesLead(std::size_t polygon, std::size_t edge, std::size_t goal) const {
    const Exits& exits = exits_[polygon];
    const Number number = numbers_[goal];
    if (!exits[edge].empty()) return exits[edge].contains(number);
    for (const Range& other : exits) {
      if (other.contains(number)) return false;
    }
    return true;
  }
  /// @brief Memory that it occupies [bytes].
  std::size_t bytes() const { return numbers_.capacity() * sizeof(Number) + exits_.capacity() * sizeof(Exits); }

 private:
  using Number = std::uint16_t;  // a mesh has at most 32,767 polygons
  /// Numbers of the polygons behind an edge that can only be reached through the polygon of the edge; empty if all
  /// other polygons can be reached without it.
  struct Range {
    Number first = 1;
    Number last = 0;
    bool empty() const { return first > last; }
    bool contains(Number number) const { return first <= number && number <= last; }
  };
  using Exits = std::array<Range, DT_VERTS_PER_POLYGON>;

  struct Visits;
  void visitComponent(const dtMeshTile& mesh, std::size_t first, Visits& visits);

  std::vector<Number> numbers_;  // of the polygons
  std::vector<Exits> exits_;     // of the polygons
};

}  // namespace crowd
