#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "maps/floor_plan.h"
#include "robots/metrics/observed_scene.h"

namespace crowd {

/// @brief The size of the floor on which the people and robots of an episode walk, for densities.
///
/// It is the floor that is connected with a place, at least MARGIN away from walls and obstacles at rest, with all
/// gates open. If walls do not enclose it, only its part in a rectangle counts. The floor is searched at the first call
/// of size(). Not thread-safe.
class WalkableArea {
 public:
  static constexpr double MARGIN = 0.1;   ///< nobody's centre comes nearer to a wall [m]
  static constexpr double SPACING = 0.1;  ///< of the points that are counted [m]

  /// @param gates walls of the gates @param place [m]
  WalkableArea(const ObservedScene& scene, const std::vector<Segment>& gates, const Vector2& place);

  /// @brief The size [m^2]. @param used of which the rectangle is the smallest that contains it [m]
  double size(const Eigen::AlignedBox2d& used) const;

 private:
  /// The points of the connected floor.
  struct Points {
    std::vector<Vector2> list;
    double cell = 0.0;  // area for each of them [m^2]
    bool are_enclosed = false;
    Eigen::AlignedBox2d grid;  // contains all points of the search
  };
  Points search() const;

  FloorPlan floor_;
  Vector2 place_;
  mutable std::optional<Points> points_;
};

}  // namespace crowd
