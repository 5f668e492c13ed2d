#pragma once

#include <cmath>

namespace crowd {

/// @brief Agents are sorted into sizes in steps of this radius [m], so that a crowd with many different radii needs few
/// meshes.
constexpr double SIZE_STEP = 0.05;

/// @brief The size of an agent: its radius, rounded up to a multiple of SIZE_STEP, to within rounding [m].
inline double sizeOf(double radius) {
  constexpr double ROUNDING = 1e-6;  // of radii that are multiples of the step [steps]
  return SIZE_STEP * std::ceil(radius / SIZE_STEP - ROUNDING);
}

}  // namespace crowd
