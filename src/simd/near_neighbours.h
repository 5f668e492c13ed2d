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

/// @brief Criterion for neighbours near which an agent stops.
struct StoppingNearness {
  double stop_x;  ///< where the agent stops if it brakes from now on [m]
  double stop_y;
  double tick_duration;  ///< [s]
  double per_braking;    ///< 1 / (2 * braking) [s2/m]
  double room;           ///< threshold, without the radius of the neighbour [m]
};

/// @brief Returns a mask as FindNear does. Neighbour i at position p with velocity v is near if
/// |p| - room - tick_duration |v| - radius_i is not more than both come towards each other before they stop, along p:
/// (max(0, p.stop) + max(0, -p.v |v| per_braking)) / |p|.
using FindNearStop = std::uint32_t(const NeighbourArrays& neighbours, const StoppingNearness& nearness);

}  // namespace crowd::simd
