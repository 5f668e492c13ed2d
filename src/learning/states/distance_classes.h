#pragma once

#include "scenario/scene.h"

namespace crowd {

/// @brief The thesis's two distance classes, by the distance from the agent's centre to the other's rim.
struct DistanceClasses {
  static constexpr int COUNT = 2;
  static constexpr double DEFAULT_VISION_RADIUS = 1.0;

  double collision_radius = DEFAULT_COLLISION_RADIUS;  ///< [m], outer limit of class 1
  double vision_radius = DEFAULT_VISION_RADIUS;        ///< [m], outer limit of class 2

  /// @brief Returns 1 within the collision radius, 2 within the radius of vision (limits included), 0 beyond.
  /// @param rim_distance distance from the agent's centre to the other's rim [m]
  int classOf(double rim_distance) const {
    if (rim_distance <= collision_radius) return 1;
    return rim_distance <= vision_radius ? 2 : 0;
  }
};

}  // namespace crowd
