#pragma once

#include <optional>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Everything that a person on a plane floor has to walk around. Input of NavigationMesh.
///
/// Walls may come from a scenario or from the edges of a map's cells: any number of segments in any direction, also
/// ones that touch, cross or have no length. A space that they enclose is part of the floor like any other.
struct FloorPlan {
  /// @brief A round obstacle at rest.
  struct Disc {
    Vector2 centre = Vector2::Zero();  ///< [m]
    double radius = 0.0;               ///< [m]
  };
  /// @brief A rectangle along the axes [m].
  struct Bounds {
    Vector2 low = Vector2::Zero();
    Vector2 high = Vector2::Zero();
  };

  std::vector<Segment> walls;
  std::vector<Disc> obstacles;
  /// The floor; its edges are not walls. Absent: the rectangle around walls and obstacles, and MARGIN on each side.
  std::optional<Bounds> bounds;

  static constexpr double MARGIN = 4.0;  ///< [m]

  /// @brief The bounds, or the ones that are computed from walls and obstacles.
  /// @throws InputError if a number is not finite, a radius is negative, the bounds are empty, or there are neither
  /// bounds nor walls nor obstacles
  Bounds checkedBounds() const;
};

}  // namespace crowd
