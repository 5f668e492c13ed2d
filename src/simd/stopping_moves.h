#pragma once

#include <cstddef>

namespace crowd::simd {

/// @brief Upper bound of where an agent that moves for a tick, and brakes afterwards, stops in one direction.
struct StopLimit {
  double normal_x;  ///< the direction, unit vector
  double normal_y;
  double square;     ///< 2 * braking * the greatest advance [m2/s2]
  double lost;       ///< speed that braking takes away in a tick [m/s]
  double per_speed;  ///< 1 / the maximum speed of the agent [s/m]
};

/// @brief Lowers the fractions of the maximum speed of moves, so that the agent stops before the limit: the speed v in
/// a direction with the share c along the normal, c > 0, is at most that with c (v T + v^2 / (2 braking)) = advance.
/// @param xs, ys directions of the moves, unit vectors @param count of the moves, a multiple of 8
using CutStops = void(const StopLimit& limit, const double* xs, const double* ys, std::size_t count, double* fractions);

}  // namespace crowd::simd
