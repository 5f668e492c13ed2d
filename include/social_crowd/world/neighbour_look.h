#pragma once

#include <cstdint>

#include "social_crowd/world/neighbour_grid.h"

namespace crowd {

/// @brief Whether a run has a disc whose rim is within `distance` [m] of the point, those of one body not counted.
using Look = bool (*)(const NeighbourGrid& grid, const NeighbourGrid::Run& run, const Vector2& point, double distance,
                      std::uint32_t except);

/// @brief A Look for every machine.
bool lookAnywhere(const NeighbourGrid& grid, const NeighbourGrid::Run& run, const Vector2& point, double distance,
                  std::uint32_t except);

/// @brief The fastest Look that this processor can run; all tell the same.
Look fastestLook();

}  // namespace crowd
