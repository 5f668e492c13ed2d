#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/world/neighbour_grid.h"

namespace crowd {

/// @brief Discs of a grid that a search looks at, as lists side by side: `count` of each are valid, and behind them is
/// room for a block of others. The lists only grow.
struct NeighbourCandidates {
  static constexpr std::size_t BLOCK = 16;  ///< so many are worked on at once

  std::size_t count = 0;
  std::vector<std::uint32_t> discs;  ///< their places in the grid
  std::vector<double> radii;         ///< [m]
  std::vector<double> squares;       ///< squared distances of their centres from the point [m2]
  std::vector<double> rims;          ///< distances of their rims from the point [m], once findRims() was called

  /// @brief Makes the lists long enough for so many discs and a block.
  void makeRoom(std::size_t most);
  /// @brief Writes `rims`.
  void findRims();
};

/// @brief Writes down the discs of the runs whose rim is within `distance` [m] of the point, except those of one body,
/// in the order of the runs. There must be room for all discs of the runs.
using Gather = void (*)(const NeighbourGrid& grid, const View<NeighbourGrid::Run>& runs, const Vector2& point,
                        double distance, std::uint32_t except, NeighbourCandidates& candidates);

/// @brief A Gather for every machine.
void gatherAnywhere(const NeighbourGrid& grid, const View<NeighbourGrid::Run>& runs, const Vector2& point,
                    double distance, std::uint32_t except, NeighbourCandidates& candidates);

/// @brief The fastest Gather that this processor can run; all give the same bits.
Gather fastestGather();

}  // namespace crowd
