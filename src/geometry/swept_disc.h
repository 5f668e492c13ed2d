#pragma once

#include <algorithm>

#include "geometry/geometry.h"

namespace crowd {

/// @brief The area that a disc covers while it moves straight along a path.
class SweptDisc {
 public:
  /// @param radius of the disc [m]
  SweptDisc(const Segment& path, double radius)
      : path_(path),
        radius_squared_(radius * radius),
        low_(path.from.cwiseMin(path.to).array() - radius),
        high_(path.from.cwiseMax(path.to).array() + radius) {}

  /// @brief Whether the disc overlaps a wall anywhere on its path, or touches it if its radius is 0.
  bool overlaps(const Segment& wall) const {
    if (!isBoxNear(wall)) return false;
    if (crosses(wall)) return true;
    // The nearest points of segments that do not cross include an end of one of them.
    const double nearest = std::min({squaredDistance(path_, wall.from), squaredDistance(path_, wall.to),
                                     squaredDistance(wall, path_.from), squaredDistance(wall, path_.to)});
    return nearest < radius_squared_ || nearest <= 0.0;
  }

 private:
  static double squaredDistance(const Segment& segment, const Vector2& point) {
    return (nearestPoint(segment, point) - point).squaredNorm();
  }
  static bool areOnBothSides(double a, double b) { return (a <= 0.0 && b >= 0.0) || (a >= 0.0 && b <= 0.0); }

  bool isBoxNear(const Segment& wall) const {
    return (wall.from.array() <= high_ || wall.to.array() <= high_).all() &&
           (wall.from.array() >= low_ || wall.to.array() >= low_).all();
  }

  /// Whether path and wall have a common point, unless they are on one line.
  bool crosses(const Segment& wall) const {
    const Vector2 along = path_.to - path_.from;
    const Vector2 along_wall = wall.to - wall.from;
    const double wall_from = cross(along, wall.from - path_.from);
    const double wall_to = cross(along, wall.to - path_.from);
    const double path_from = cross(along_wall, path_.from - wall.from);
    const double path_to = cross(along_wall, path_.to - wall.from);
    const bool is_on_one_line = wall_from == 0.0 && wall_to == 0.0 && path_from == 0.0 && path_to == 0.0;
    return !is_on_one_line && areOnBothSides(wall_from, wall_to) && areOnBothSides(path_from, path_to);
  }

  Segment path_;
  double radius_squared_;
  Eigen::Array2d low_;  // of the box around the area [m]
  Eigen::Array2d high_;
};

}  // namespace crowd
