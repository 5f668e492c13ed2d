#pragma once

#include <cstddef>

#include "social_crowd/world/neighbour_grid.h"
#include "social_crowd/world/neighbour_search.h"
#include "social_crowd/world/perceived_bodies.h"
#include "social_crowd/world/view.h"

namespace crowd {

/// @brief Agents among the discs of a grid, and the one that sees them.
struct SeenDiscs {
  const NeighbourGrid& grid;
  View<NearDisc> discs;
  const Vector2& position;  ///< of the agent, `map` [m]
  const Vector2& ahead;     ///< unit vector of its heading
};

/// @brief Writes agents to the bodies from number `first` on, four at a time. Returns how many are done: up to three
/// are left. There must be room for all.
std::size_t writeFours(const SeenDiscs& seen, std::size_t first, PerceivedBodies& bodies);

}  // namespace crowd
