#pragma once

#include <algorithm>

#include "avoidance/candidate_move.h"
#include "geometry/geometry.h"

namespace crowd {

/// @brief Upper bound of a displacement in one direction, agent frame.
struct MoveLimit {  // NOLINT(cppcoreguidelines-pro-type-member-init): an array of limits is not written twice
  Vector2 normal;
  double max_advance;  ///< along `normal` [m]
};

/// @brief Makes all wanted fractions admissible. Copies whole vector registers: narrower stores could not be forwarded
/// to the wide loads that follow.
inline void admitAll(MoveBlock& moves) {
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) moves.fraction[i] = moves.wanted[i];
}

/// @brief Limits the displacement of each move in a tick. @param reach that at full speed [m]
inline void cutDisplacement(const MoveLimit& limit, double reach, MoveBlock& moves) {
  const double nx = limit.normal.x();
  const double ny = limit.normal.y();
  for (std::size_t i = 0; i < MoveBlock::SIZE; ++i) {
    const double advance = reach * (nx * moves.x[i] + ny * moves.y[i]);
    const bool too_far = (advance > 0.0) & (moves.fraction[i] * advance > limit.max_advance);
    const double left = limit.max_advance / advance;
    moves.fraction[i] = too_far ? left : moves.fraction[i];
  }
}

}  // namespace crowd
