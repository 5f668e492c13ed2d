#pragma once

#include <string>
#include <vector>

#include "common/text/numbers.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief A place for messages, such as "(1, 2.5)".
inline std::string placeText(const Vector2& place) { return "(" + toText(place.x()) + ", " + toText(place.y()) + ")"; }

/// @brief Whether a point [m] is in a box or ring, or is the point of the region. Not for FREE.
bool contains(const Region& region, const Vector2& point);

/// @brief The point of a point, box or ring that is nearest to another one [m]. Not for FREE.
Vector2 nearestPoint(const Region& region, const Vector2& point);

/// @brief The middle of a point, box or ring [m]. Not for FREE.
Vector2 middleOf(const Region& region);

/// @brief A region without the margin along its edge [m]; at least the middle is left. Not for FREE.
Region shrink(const Region& region, double margin);

/// @brief Points of a square grid in a box or ring, or the point of the region [m]. Not for FREE.
/// @param spacing wanted distance between them [m]; it grows for large regions, so that there are at most some 10000
std::vector<Vector2> gridPoints(const Region& region, double spacing);

}  // namespace crowd
