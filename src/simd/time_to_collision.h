#pragma once

#include <cstddef>

#include "simd/neighbour_arrays.h"

namespace crowd::simd {

/// @brief The agent whose times to collision are computed, in its own frame.
struct Observer {
  double radius;     ///< [m]
  float velocity_x;  ///< in the last tick [m/s]
  float velocity_y;
  float preferred_x;  ///< preferred velocity, without neighbours [m/s]
  float preferred_y;
};

/// @brief Candidate velocities of an agent, and the inverse time to collision of each [1/s]. All arrays have MAX
/// elements; those behind the first `count` are unspecified, and may be overwritten.
struct CandidateArrays {
  static constexpr std::size_t MAX = 24;

  std::size_t count;
  const float* xs;  ///< [m/s]
  const float* ys;
  float* constant_velocity;  ///< 1 / time, if neighbours keep their velocities
  float* reciprocal;         ///< 1 / time relative to the mean of own and neighbour's velocity; nullptr: not computed
};

/// @brief Factor that replaces 1 / gap for neighbours that already touch [1/m2].
constexpr float AT_ONCE = 1e30F;

/// @brief Raises each inverse time to the maximum over the neighbours.
/// @return square of the highest approach speed of a neighbour at the preferred velocity [m2/s2]; 0 if none approaches
using AccumulateTimeToCollision = float(const NeighbourArrays& neighbours, const Observer& self,
                                        const CandidateArrays& candidates);

}  // namespace crowd::simd
