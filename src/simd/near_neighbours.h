#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/neighbour_arrays.h"

namespace crowd::simd {

/// @brief What makes a neighbour near.
struct Nearness {
  double velocity_x;  ///< of the agent in the last tick [m/s]
  double velocity_y;
  double tick_duration;  ///< [s]
  double room;           ///< near is who is within this and its own radius after the next tick [m]
};

/// @brief Up to so many neighbours are looked at in one call.
constexpr std::size_t MAX_LOOKED_AT = 16;

/// @brief Those of the first MAX_LOOKED_AT neighbours that are near if both mean velocities stay as they are and nobody
/// parts: bit i stands for neighbour i.
using FindNear = std::uint32_t(const NeighbourArrays& neighbours, const Nearness& nearness);

}  // namespace crowd::simd
