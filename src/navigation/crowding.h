#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "world/world.h"

namespace crowd {

/// @brief Returns the number of agents whose centres are within a distance of a place, and not behind a wall.
/// @param place [m], `map` @param distance [m] @param found a buffer
inline std::size_t countPeopleNear(const World& world, const Vector2& place, double distance,
                                   std::vector<std::uint32_t>& found) {
  found.clear();
  world.grid().findNear(place, distance, found);
  return static_cast<std::size_t>(std::count_if(found.begin(), found.end(), [&](std::uint32_t body) {
    if (body >= world.agents().size()) return false;  // an obstacle
    const Vector2& centre = world.agents().nth(body).pose.position;
    return (centre - place).norm() <= distance && world.walls().index().isClear(place, centre, 0.0);
  }));
}

}  // namespace crowd
