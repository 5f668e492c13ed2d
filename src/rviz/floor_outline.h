#pragma once

#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Lines on the floor: points of each, joined in this order [m].
using FloorOutline = std::vector<std::vector<Vector2>>;

/// @brief The rim of a disc, closed [m].
std::vector<Vector2> circleOutline(const Vector2& centre, double radius);

/// @brief An upright cross [m].
FloorOutline crossOutline(const Vector2& centre, double radius);

}  // namespace crowd
