#pragma once

#include <cstddef>
#include <cstdint>

namespace crowd::simd {

/// @brief Places and velocities, four numbers each (x, y [m], vx, vy [m/s]), and those of them that are wanted. Up to
/// PADDING numbers behind the last wanted one are used, too: they must be of a row.
struct WantedMotions {
  static constexpr std::size_t PADDING = 4;

  const double* rows;
  const std::uint32_t* wanted;  ///< numbers of rows
  std::size_t count;            ///< of these
};

/// @brief An agent's frame: x ahead, y left.
struct Frame {
  double x;  ///< its place [m]
  double y;
  double ahead_x;  ///< unit vector of its heading
  double ahead_y;
};

/// @brief Where motions are written, each number in an array of its own. There must be room for PADDING more numbers,
/// which are overwritten.
struct MotionArrays {
  double* xs;
  double* ys;
  double* vxs;
  double* vys;
};

/// @brief Turns places and velocities into an agent's frame.
using TurnIntoFrame = void(const WantedMotions& motions, const Frame& frame, const MotionArrays& turned);

}  // namespace crowd::simd
