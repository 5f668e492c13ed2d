#pragma once

#include <optional>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Returns the direction in which a body slides along what it touches: `direction` without the parts towards the
/// contacts, as a unit vector. Returns nothing if no contact is in the way, or if (nearly) no direction is left.
/// @param direction unit vector
/// @param contacts unit vectors from the body to what it touches
std::optional<Vector2> slideAlong(const Vector2& direction, const std::vector<Vector2>& contacts);

}  // namespace crowd
