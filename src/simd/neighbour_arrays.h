#pragma once

#include <cstddef>

namespace crowd::simd {

/// @brief Neighbours in an agent's frame as one array for each of their numbers. Up to PADDING numbers behind the last
/// neighbour are read, whatever they are.
struct NeighbourArrays {
  static constexpr std::size_t PADDING = 16;

  const double* xs;  ///< of the centres [m]
  const double* ys;
  const double* vxs;  ///< velocities over ground [m/s]
  const double* vys;
  const double* radii;  ///< [m]
  std::size_t count;
};

}  // namespace crowd::simd
