#pragma once

#include <cstddef>

namespace crowd::simd {

/// @brief Neighbours in an agent's frame as a structure of arrays. Kernels read up to PADDING unspecified elements
/// behind the last neighbour.
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
