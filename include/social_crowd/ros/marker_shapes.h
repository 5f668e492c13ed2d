#pragma once

#include <visualization_msgs/Marker.h>

#include <cstdint>
#include <vector>

#include "social_crowd/ros/marker_style.h"
#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief One marker that holds any number of shapes, each point with a colour of its own.
///
/// The layer is the height of the marker's pose, not of its points: RViz sorts what is translucent by the pose.
class ListMarker {
 public:
  using Colour = marker_style::Colour;

  /// @brief The marker with all its shapes, to be added; or to be deleted if there are none, as RViz takes an empty
  /// list for an error. Leaves nothing behind.
  visualization_msgs::Marker finish();

 protected:
  ListMarker(const char* kind, int id, marker_style::Layer layer, int type);
  void addPoint(const Vector2& position, const Colour& colour);

  visualization_msgs::Marker marker_;
};

/// @brief A circle of radius 1 as a polygon, counterclockwise.
std::vector<Vector2> unitCircle(std::size_t corners);

/// @brief Filled shapes (TRIANGLE_LIST).
class TriangleMarker : public ListMarker {
 public:
  TriangleMarker(const char* kind, int id, marker_style::Layer layer);

  void addTriangle(const Vector2& a, const Vector2& b, const Vector2& c, const Colour& colour);
  /// @param circle see unitCircle()
  void addDisc(const Vector2& centre, double radius, const std::vector<Vector2>& circle, const Colour& colour);
  /// @brief A ring between two radii [m].
  void addRing(const Vector2& centre, double inner, double outer, const std::vector<Vector2>& circle,
               const Colour& colour);
  /// @brief Tells where a body of this radius looks.
  void addArrow(const Pose& pose, double radius, const Colour& colour);
  /// @brief Part of a ring between two radii [m] and two angles of the map [rad], `from` <= `to`.
  void addRingPart(const Vector2& centre, double inner, double outer, double from, double to, const Colour& colour);

 private:
  /// The part of a ring between two directions (unit vectors), with straight rims.
  void addRingPiece(const Vector2& centre, double inner, double outer, const Vector2& from, const Vector2& to,
                    const Colour& colour);
};

/// @brief Lines (LINE_LIST).
class LineMarker : public ListMarker {
 public:
  /// @param width of the lines [m]
  LineMarker(const char* kind, int id, marker_style::Layer layer, double width);

  void addLine(const Vector2& from, const Vector2& to, const Colour& colour);
  /// @param circle see unitCircle()
  void addCircle(const Vector2& centre, double radius, const std::vector<Vector2>& circle, const Colour& colour);
  /// @brief Two lines like an X.
  void addCross(const Vector2& centre, double size, const Colour& colour);
};

}  // namespace crowd
