#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "meshes/mesh_data.h"

namespace crowd {

/// Finds shortest paths on the polygons of a mesh with Polyanya (Cui, Harabor and Grastien 2017): an A* search over
/// intervals of polygon edges that are visible from the last corner of the path. All coordinates are in cells.
///
/// Detour's own search, which connects middles of edges, finds paths that are longer (docs/way_finding.md).
class PathSearch {
 public:
  explicit PathSearch(const NavigationMesh::Data& mesh);

  /// Writes the corners of the shortest path between two points to `corners`, without the start, with the goal.
  /// Returns false if there is none that is at most `max_length` long.
  bool find(std::size_t from_polygon, const Vector2& from, std::size_t to_polygon, const Vector2& to, double max_length,
            std::vector<Vector2>& corners);
  /// Paths lead through none of these polygons, but may begin and end there.
  void close(std::vector<std::size_t> polygons) { closed_ = std::move(polygons); }
  std::size_t bytes() const;

 private:
  using Index = std::uint32_t;
  static constexpr Index NONE = UINT32_MAX;

  /// A point of an edge; `vertex` is its number if it is a corner of polygons.
  struct Point {
    Vector2 position = Vector2::Zero();
    Index vertex = NONE;
  };
  /// Start of the last straight part of a path.
  struct Root {
    Vector2 position = Vector2::Zero();
    double length = 0.0;  // of the path to it
    Index parent = NONE;
    Index vertex = NONE;
  };
  /// The part of an edge that is visible from a root, and the polygon behind it; or the goal.
  struct Node {
    double estimate = 0.0;  // length of a path to the goal, at least
    Index number = 0;
    Index root = 0;
    Index polygon = NONE;  // NONE: the goal, in sight of the root
    Index edge = 0;        // of this polygon
    Point right;
    Point left;
  };
  struct IsWorse {
    bool operator()(const Node& a, const Node& b) const {
      return a.estimate != b.estimate ? a.estimate > b.estimate : a.number > b.number;
    }
  };
  /// A point on the boundary of a polygon, on the side between chain points `side` and `side` + 1.
  struct Cut {
    std::size_t side = 0;
    Point point;
  };

  void begin(std::size_t polygon, const Vector2& from);
  void expand(const Node& node);
  void expandVisible(const Node& node);
  void reachGoal(const Node& node);
  void setChain(Index polygon, Index entry_edge);
  Cut firstCut(const Vector2& root, const Vector2& through) const;
  Cut lastCut(const Vector2& root, const Vector2& through) const;
  Cut chainBegin() const { return {0, chain_.front()}; }
  Cut chainEnd() const { return {chain_.size() - 2, chain_.back()}; }
  /// The part of the chain between two cuts can be seen from a root.
  void addSides(Index root, Index polygon, const Cut& first, const Cut& last);
  void addInterval(Index root, Index polygon, Index edge, const Point& right, const Point& left);
  void addGoal(Index root);
  void add(Node node);
  /// A new root at the end of an interval; NONE if no shortest path turns there.
  Index turnAt(const Point& corner, Index root);
  bool isOutdated(const Root& root) const;
  double estimate(const Vector2& root, const Point& right, const Point& left) const;
  Point point(Index vertex) const;

  const NavigationMesh::Data& mesh_;
  std::vector<std::size_t> closed_;  // few
  std::size_t goal_polygon_ = 0;
  Vector2 goal_ = Vector2::Zero();
  double max_length_ = 0.0;
  std::vector<Root> roots_;
  std::vector<Node> open_;  // heap
  Index number_ = 0;
  std::vector<double> best_;    // shortest known path to each vertex
  std::vector<Index> touched_;  // vertices for which this is not infinite
  std::vector<Point> chain_;    // corners of the polygon that is expanded, from the right to the left of its entry
  std::vector<Index> sides_;    // edges between them
};

}  // namespace crowd
