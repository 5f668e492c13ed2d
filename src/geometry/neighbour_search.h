#pragma once

#include <cstdint>
#include <vector>

#include "common/span.h"
#include "geometry/neighbour_grid.h"

namespace crowd {

/// @brief A disc, and the distance from the query point to its rim [m]; negative if the point is inside.
struct NearDisc {
  double rim_distance = 0.0;
  std::uint32_t disc = 0;  ///< its index in the grid, see NeighbourGrid
};

/// @brief Finds the discs of a grid that are nearest to a point. Use one object per thread. It keeps its workspace and
/// starts with the radius of the previous search, which makes searches in the order of the grid's cells fast. The
/// result does not depend on previous searches.
class NeighbourSearch {
 public:
  /// @brief Returns the discs whose rim is within `distance` [m] of the point, nearest rim first, equal distances in
  /// the order of their bodies; at most `max_count` of them (0: all). Valid until the next search.
  /// @param except body that is ignored
  Span<NearDisc> findNearest(const NeighbourGrid& grid, const Vector2& point, double distance, std::size_t max_count,
                             std::uint32_t except);

 private:
  /// Linear search with insertion sort.
  Span<NearDisc> findInShortList(const NeighbourGrid& grid, const Vector2& point, double distance,
                                 std::size_t max_count, std::uint32_t except);
  Span<NearDisc> findInRuns(const NeighbourGrid& grid, const Vector2& point, double distance, std::size_t max_count,
                            std::uint32_t except);
  /// Writes the discs whose rim is within the distance to `discs_` and `rims_`, and sets `count_`.
  void collect(const NeighbourGrid& grid, const Vector2& point, double distance, std::uint32_t except);
  /// Returns false if two rims are equally far in single precision.
  bool sortByRank();
  void sortBySelection(const NeighbourGrid& grid, std::size_t max_count);

  double last_reach_ = 0.0;  // radius that the last search needed [m]
  // Workspace; the vectors only grow.
  NeighbourGrid::Runs runs_;
  std::size_t count_ = 0;             // of collected discs
  std::vector<std::uint64_t> discs_;  // their indices in the grid
  std::vector<double> rims_;          // distances from the point to their rims [m]
  std::vector<NearDisc> found_;       // sorted
};

}  // namespace crowd
