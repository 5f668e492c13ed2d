#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Outline of a robot in its own frame: a disc about the origin, or a polygon, which may be concave.
struct Footprint {
  double radius = 0.0;           ///< of the disc [m]; unused with corners
  std::vector<Vector2> corners;  ///< of the polygon, in either direction [m], robot frame; empty: a disc

  bool isDisc() const { return corners.empty(); }
  /// @brief Radius of the smallest disc about the origin that contains the footprint [m].
  double reach() const;
  /// @brief The corners of the polygon at a pose [m], in the frame of the pose.
  std::vector<Vector2> cornersAt(const Pose& pose) const;
};

/// @brief Distance from a footprint at a pose to a point [m]; negative inside, by the depth.
double distance(const Footprint& footprint, const Pose& pose, const Vector2& point);
/// @brief Distance to a segment [m]. 0 or less if they have a common point; of a disc, this is the depth of the
/// overlap.
double distance(const Footprint& footprint, const Pose& pose, const Segment& segment);
/// @brief Whether a footprint overlaps a segment by more than a tolerance [m]. The depth in a polygon is not known: for
/// polygons, any common point counts.
bool isCutBy(const Footprint& footprint, const Pose& pose, const Segment& segment, double tolerance);
/// @brief Distance between two footprints [m]; 0 or less if they have a common point.
double distance(const Footprint& first, const Pose& first_pose, const Footprint& second, const Pose& second_pose);

/// @brief What is wrong with the corners of a polygon: fewer than 3, edges that cross or touch, or no area. Empty if
/// nothing is.
std::string problemOf(const std::vector<Vector2>& corners);

}  // namespace crowd
