#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "common/stop_request.h"
#include "maps/floor_plan.h"

namespace crowd {

/// @brief A way from one point to another: straight from corner to corner.
struct Path {
  std::vector<Vector2> corners;  ///< where it turns, and at last the goal; without the start [m]
  double length = 0.0;           ///< from the start [m]
};

/// @brief The part of a floor on which a disc of a given radius can walk, for finding ways (docs/way_finding.md).
///
/// - Each point of the mesh is at least clearance() - tolerance() away from all walls and obstacles.
/// - Passages that are at least two cells wider than twice the clearance are part of the mesh, in any direction.
/// - The mesh, and all answers, depend on floor plan, clearance and cell size only.
///
/// Immutable. Ways are found with a NavigationMesh::Query: one for each thread, at the same time.
class NavigationMesh {
 public:
  class Query;
  class Data;
  /// @brief Number of a connected part of the mesh, from 0.
  using Component = std::uint32_t;

  static constexpr double DEFAULT_CELL_SIZE = 0.05;  ///< [m]

  /// @param clearance of the middle of a person from walls and obstacles, i.e. radius and a margin [m], above 0
  /// @param cell_size of the raster that the mesh is made of [m], above 0; it is smaller for a clearance of less than 4
  /// cells, and larger for large floors (from 20,000 m2 with the default), see cellSize()
  /// @throws InputError if the plan is invalid, clearance or cell size are not above 0, or the floor is too large for
  /// the clearance; Stopped if `stop` is made
  explicit NavigationMesh(const FloorPlan& plan, double clearance, double cell_size = DEFAULT_CELL_SIZE,
                          const StopRequest& stop = {});

  double clearance() const;  ///< [m]
  double cellSize() const;   ///< [m]
  /// @brief Greatest difference by which the mesh is closer to walls and obstacles than the clearance: 0.42 cells [m].
  double tolerance() const;
  std::size_t componentCount() const;
  /// @brief Its convex polygons, counterclockwise [m]; for drawings and checks.
  std::vector<std::vector<Vector2>> polygons() const;
  /// @brief Memory that it occupies [bytes].
  std::size_t bytes() const;

 private:
  std::shared_ptr<const Data> data_;
};

/// @brief Finds ways on a mesh, which it keeps alive. Used by one thread at a time.
class NavigationMesh::Query {
 public:
  explicit Query(const NavigationMesh& mesh);
  ~Query();
  Query(Query&&) noexcept;
  Query& operator=(Query&&) noexcept;

  double clearance() const;  ///< of the mesh [m]
  /// @brief The point of the mesh nearest to p, if it is at most `within` away [m].
  std::optional<Vector2> nearestPoint(const Vector2& p, double within);
  /// @brief Whether p is on the mesh.
  bool contains(const Vector2& p);
  /// @brief The component that p is on, or whose nearest point is at most clearance() away.
  ///
  /// Two points are connected by a way if they have the same component.
  std::optional<Component> component(const Vector2& p);
  /// @brief The shortest way on the mesh between two points that are on it, or at most clearance() away from it.
  ///
  /// On the mesh, it keeps clearance() - tolerance() from walls and obstacles. At an end that is not on the mesh,
  /// the way is straight between this end and the nearest point of the mesh, and does not cross a wall there if the end
  /// is more than tolerance() away from all walls.
  /// @param max_length of the way [m]; a search for a short way between points near each other costs little
  /// @return std::nullopt if the mesh does not connect them, or only by a longer way
  std::optional<Path> findPath(const Vector2& from, const Vector2& to,
                               double max_length = std::numeric_limits<double>::infinity());
  /// @brief The shortest way that passes no polygon of the mesh within a disc, except those of its ends.
  std::optional<Path> findWayAround(const FloorPlan::Disc& disc, const Vector2& from, const Vector2& to,
                                    double max_length);
  /// @brief Whether the straight line between two points is on the mesh (beyond rounding).
  ///
  /// Both may be off the mesh by up to the clearance; then the nearest points count.
  bool isStraight(const Vector2& from, const Vector2& to);
  /// @brief Memory that it occupies [bytes].
  std::size_t bytes() const;

 private:
  class Search;
  std::unique_ptr<Search> search_;
};

}  // namespace crowd
