#pragma once

#include <cmath>
#include <string>

#include "common/text/numbers.h"
#include "geometry/geometry.h"
#include "geometry/limits.h"
#include "social_crowd/errors.h"

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

inline void requireWithin(const NumberLimit& limit, const std::string& what, double value) {
  requireFinite(what, value);
  const std::string refusal = refusalOf(value, limit);
  if (!refusal.empty()) throw InputError(what + ": expected " + refusal + ", got " + toText(value));
}

inline void requireWithin(const NumberLimit& limit, const std::string& what, const Vector2& value) {
  requireFinite(what, value);
  for (const double coordinate : {value.x(), value.y()}) requireWithin(limit, what, coordinate);
}

inline void requirePlace(const std::string& what, const Vector2& place) { requireWithin(limits::PLACE, what, place); }

inline void requirePose(const Pose& pose) {
  requirePlace("position [m]", pose.position);
  requireFinite("heading [rad]", pose.heading);
}

}  // namespace crowd
