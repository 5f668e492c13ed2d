#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/neighbour_arrays.h"

namespace crowd::simd {

/// @brief Criterion for near neighbours.
struct Nearness {
  double velocity_x;  ///< of the agent in the last tick [m/s]
  double velocity_y;
  double tick_duration;  ///< [s]
  double room;           ///< threshold, without the radius of the neighbour [m]
};

/// @brief Maximum number of neighbours that one call considers.
constexpr std::size_t MAX_LOOKED_AT = 16;

/// @brief Returns a mask of the near ones among the first MAX_LOOKED_AT neighbours; bit i stands for neighbour i.
/// Neighbour i at position p is near if |p| + tick_duration * min(0, p.(v + v_i) / |p|) <= room + radius_i. The second
/// term is twice the approach of the plane between both, which moves with the mean of their velocities v and v_i.
using FindNear = std::uint32_t(const NeighbourArrays& neighbours, const Nearness& nearness);

}  // namespace crowd::simd
