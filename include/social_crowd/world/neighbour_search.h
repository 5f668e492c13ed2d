#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/world/neighbour_grid.h"
#include "social_crowd/world/span.h"

namespace crowd {

/// @brief A disc that was found, and how far its rim is away [m]; negative from a point within it.
struct NearDisc {
  double rim_distance = 0.0;
  std::uint32_t disc = 0;  ///< its place in the grid, see NeighbourGrid
};

/// @brief Finds the discs of a grid that are nearest to a point. One object serves one thread; it keeps its working
/// space, and begins as near as the last search ended, so that searches in the order of the grid's cells are fast. What
/// is found does not depend on that.
class NeighbourSearch {
 public:
  /// @brief The discs whose rim is within `distance` [m] of the point, nearest rim first, equal ones by their body's
  /// number; not more than `most` of them (0: all). Valid until the next search.
  /// @param except a body that is left out
  Span<NearDisc> findNearest(const NeighbourGrid& grid, const Vector2& point, double distance, std::size_t most,
                             std::uint32_t except);

 private:
  /// One disc after the other.
  Span<NearDisc> findInShortList(const NeighbourGrid& grid, const Vector2& point, double distance, std::size_t most,
                                 std::uint32_t except);
  Span<NearDisc> findInRuns(const NeighbourGrid& grid, const Vector2& point, double distance, std::size_t most,
                            std::uint32_t except);
  /// Writes down the discs whose rim is within the distance; makes `count_` of them.
  void collect(const NeighbourGrid& grid, const Vector2& point, double distance, std::uint32_t except);
  /// Fails if two candidates are equally far.
  bool sortByRank();
  void sortBySelection(const NeighbourGrid& grid, std::size_t most);

  double last_reach_ = 0.0;  // [m]; how far the last search had to look
  // Working space; the vectors only grow.
  NeighbourGrid::Runs runs_;
  std::size_t count_ = 0;             // of collected discs
  std::vector<std::uint64_t> discs_;  // their places in the grid
  std::vector<double> rims_;          // distances of their rims from the point [m]
  std::vector<NearDisc> found_;       // sorted
};

}  // namespace crowd
