#pragma once

#include <cmath>
#include <string>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief Checks of numbers that callers of World pass. @param what name of the number and its unit
/// @throws InputError that says what was expected and what was given
inline void requireFinite(const std::string& what, double value) {
  if (!std::isfinite(value)) throw InputError(what + ": expected a finite number, got " + toText(value));
}

inline void requireFinite(const std::string& what, const Vector2& value) {
  if (std::isfinite(value.x()) && std::isfinite(value.y())) return;
  throw InputError(what + ": expected finite numbers, got " + toText(std::vector<double>{value.x(), value.y()}));
}

inline void requireFinite(const Pose& pose) {
  requireFinite("position [m]", pose.position);
  requireFinite("heading [rad]", pose.heading);
}

inline void requireAbove0(const std::string& what, double value) {
  requireFinite(what, value);
  if (value <= 0.0) throw InputError(what + ": expected a number above 0, got " + toText(value));
}

}  // namespace crowd
