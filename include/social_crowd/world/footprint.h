#pragma once

#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief Outline of a robot in its own frame: a disc about the origin, or a polygon, which may be concave.
struct Footprint {
  double radius = 0.0;           ///< of the disc [m]; unused with corners
  std::vector<Vector2> corners;  ///< of the polygon, in either direction [m], robot frame; empty: a disc

  bool isDisc() const { return corners.empty(); }
  /// @brief Radius of the smallest disc about the origin that contains the footprint [m].
  double reach() const;
};

}  // namespace crowd
