#pragma once

#include <visualization_msgs/Marker.h>

#include <cstdint>
#include <vector>

#include "geometry/geometry.h"
#include "ros/markers/marker_style.h"

namespace crowd {

/// @brief A marker with any number of shapes; each point has its own colour.
///
/// The layer is the height of the pose of the marker, not of its points, because RViz sorts translucent markers by the
/// pose.
class ListMarker {
 public:
  using Colour = marker_style::Colour;

  /// @brief Returns the marker with all its shapes, and clears this object. Without shapes the action of the marker is
  /// DELETE, because RViz reports an empty list as an error.
  visualization_msgs::Marker finish();

 protected:
  ListMarker(const char* kind, int id, marker_style::Layer layer, int type);
  void addPoint(const Vector2& position, const Colour& colour);

  visualization_msgs::Marker marker_;
};

/// @brief Returns a circle of radius 1 as a polygon, counterclockwise.
std::vector<Vector2> unitCircle(std::size_t corners);

/// @brief Filled shapes (TRIANGLE_LIST).
class TriangleMarker : public ListMarker {
 public:
  TriangleMarker(const char* kind, int id, marker_style::Layer layer);

  void addTriangle(const Vector2& a, const Vector2& b, const Vector2& c, const Colour& colour);
  /// @param circle see unitCircle()
  void addDisc(const Vector2& centre, double radius, const std::vector<Vector2>& circle, const Colour& colour);
  /// @brief A polygon that does not cross itself; it may be concave. @param corners in either direction
  void addPolygon(std::vector<Vector2> corners, const Colour& colour);
  /// @brief A ring between two radii [m].
  void addRing(const Vector2& centre, double inner, double outer, const std::vector<Vector2>& circle,
               const Colour& colour);
  /// @brief An arrow that shows the heading of a body of this radius.
  void addArrow(const Pose& pose, double radius, const Colour& colour);
  /// @brief Part of a ring between two radii [m] and two angles of the map [rad], `from` <= `to`.
  void addRingPart(const Vector2& centre, double inner, double outer, double from, double to, const Colour& colour);

 private:
  /// Part of a ring between two directions (unit vectors), with straight rims.
  void addRingPiece(const Vector2& centre, double inner, double outer, const Vector2& from, const Vector2& to,
                    const Colour& colour);
};

/// @brief Lines (LINE_LIST).
class LineMarker : public ListMarker {
 public:
  /// @param width of the lines [m]
  LineMarker(const char* kind, int id, marker_style::Layer layer, double width);

  void addLine(const Vector2& from, const Vector2& to, const Colour& colour) { addLine(from, to, colour, colour); }
  /// @brief A line whose colour changes along it.
  void addLine(const Vector2& from, const Vector2& to, const Colour& begin, const Colour& end);
  /// @param circle see unitCircle()
  void addCircle(const Vector2& centre, double radius, const std::vector<Vector2>& circle, const Colour& colour);
  /// @param corners of a closed line
  void addPolygon(const std::vector<Vector2>& corners, const Colour& colour);
  /// @brief Two lines like an X.
  void addCross(const Vector2& centre, double size, const Colour& colour);
};

}  // namespace crowd
