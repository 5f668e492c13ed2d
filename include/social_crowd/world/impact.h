#pragma once

#include <limits>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief The answer where nothing is touched.
constexpr double NEVER = std::numeric_limits<double>::infinity();

/// @brief When a point on a straight way first comes within `reach` of another point.
///
/// A way that goes no deeper than a tenth of TOUCH_TOLERANCE only grazes, and touches nothing. Who is within reach
/// already touches at once if the way leads deeper in, and never if it leads out.
/// @param offset from the moving point to the other [m]
/// @param way of the moving point, relative to the other, in a whole tick [m]
/// @param reach [m]; for two discs the sum of their radii
/// @param rest how much of the tick is left, 0 to 1
/// @return the share of a tick from now, 0 to `rest`, or NEVER
double firstTouch(const Vector2& offset, const Vector2& way, double reach, double rest);

/// @brief The same for a wall. @param wall with the moving point as origin [m]; its ends must differ
double firstTouch(const Segment& wall, const Vector2& way, double reach, double rest);

}  // namespace crowd
