#pragma once

#include <limits>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Overlap up to which bodies only touch [m]; allows for rounding.
constexpr double TOUCH_TOLERANCE = 1e-9;

/// @brief Result of firstTouch() if there is no impact.
constexpr double NO_IMPACT = std::numeric_limits<double>::infinity();

/// @brief Maximum approach of bodies that counts as constant distance [m].
constexpr double LEAST_APPROACH = 1e-12;

/// @brief Time at which a point in uniform straight motion first comes within `reach` of another point.
///
/// A path that penetrates by at most a tenth of TOUCH_TOLERANCE grazes and does not touch. A point that is already
/// within reach touches at once if its path leads deeper, and never if it leads out.
/// @param offset vector from the moving point to the other [m]
/// @param way displacement of the moving point relative to the other in a whole tick [m]
/// @param reach [m]; for two discs the sum of their radii
/// @param rest remaining fraction of the tick, 0 to 1
/// @return time from now as a fraction of a tick, 0 to `rest`, or NO_IMPACT
double firstTouch(const Vector2& offset, const Vector2& way, double reach, double rest);

/// @brief The same for a wall. @param wall relative to the moving point [m]; its ends must differ
double firstTouch(const Segment& wall, const Vector2& way, double reach, double rest);

}  // namespace crowd
