#pragma once

#include <cstddef>

#include "simd/neighbour_arrays.h"

namespace crowd::simd {

/// @brief The agent that looks ahead.
struct Observer {
  double radius;     ///< [m]
  float velocity_x;  ///< in the last tick [m/s]
  float velocity_y;
  float preferred_x;  ///< the velocity that it would have if nobody were there [m/s]
  float preferred_y;
};

/// @brief Velocities that an agent chooses among, and how soon it would collide with each: 1 / time [1/s]. All arrays
/// have MAX numbers; what stands behind the first `count` is calculated, too, or left.
struct CandidateArrays {
  static constexpr std::size_t MAX = 24;

  std::size_t count;
  const float* xs;  ///< [m/s]
  const float* ys;
  float* constant_velocity;  ///< if neighbours keep their velocities
  float* reciprocal;         ///< if neighbours do half of what is needed, in half of the time; nullptr: not wanted
};

/// @brief 1 / time to collision of what touches already [1/s].
constexpr float AT_ONCE = 1e30F;

/// @brief Raises the inverse times to those of the neighbours that collide sooner.
/// @return the square of the fastest approach of a neighbour if the agent had its preferred velocity [m2/s2], at least
/// 0
using AccumulateTimeToCollision = float(const NeighbourArrays& neighbours, const Observer& self,
                                        const CandidateArrays& candidates);

}  // namespace crowd::simd
