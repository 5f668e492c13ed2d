#pragma once

#include <cstddef>

#include "social_crowd/world/neighbour_grid.h"
#include "social_crowd/world/neighbour_search.h"
#include "social_crowd/world/perceived_bodies.h"
#include "social_crowd/world/view.h"

namespace crowd {

/// @brief So many bodies at least are worked on at once.
constexpr std::size_t FOUR = 4;

/// @brief Discs of a grid, and the agent that sees them.
struct SeenDiscs {
  const NeighbourGrid& grid;
  View<NearDisc> discs;
  const Vector2& position;  ///< of the agent, `map` [m]
  const Vector2& ahead;     ///< unit vector of its heading
  std::size_t agents;       ///< bodies from this number on are obstacles
  bool agents_alone;        ///< there are none of those
};

/// @brief Writes the discs to the bodies from number `first` on, several at a time. Returns how many are done: less
/// than FOUR are left. There must be room for all.
std::size_t writeSideBySide(const SeenDiscs& seen, std::size_t first, PerceivedBodies& bodies);

}  // namespace crowd
