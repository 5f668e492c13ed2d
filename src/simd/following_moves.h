#pragma once

#include <cstddef>

namespace crowd::simd {

/// @brief Another agent that a walking agent may follow, agent frame.
struct Leader {
  double x;  ///< position [m]
  double y;
  double distance;    ///< [m]
  double half_width;  ///< an agent is behind it if its centre is less than this aside of the line of the move [m]
  double now;         ///< fraction of the maximum speed that the present gap admits
  double later_gap;   ///< gap after the anticipation time if the agent stands, 0 if the gap does not open [m]
  double walked;      ///< walked at full speed in the time gap [m]
  double own_way;     ///< walked at full speed in the anticipation time [m]
};

/// @brief Lowers the fractions of the maximum speed of moves towards a leader to what the gap admits: `now`, or the
/// fraction f with later_gap - f own_way cos = f walked if that is more, where cos is the cosine of the angle between
/// move and leader.
/// @param xs, ys directions of the moves, unit vectors @param count of the moves, a multiple of 8
using CutFollowing = void(const Leader& leader, const double* xs, const double* ys, std::size_t count,
                          double* fractions);

}  // namespace crowd::simd
