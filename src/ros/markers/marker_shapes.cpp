#include "ros/markers/marker_shapes.h"

#include <algorithm>
#include <cmath>

#include "ros/messages/conversions.h"
#include "ros/messages/names.h"

namespace crowd {
namespace {

/// Maximum angle of one straight segment of a curve [rad].
constexpr double MAX_TURN = PI / 24.0;

/// Twice the area of a triangle; positive if its corners are counterclockwise.
double turnOf(const Vector2& a, const Vector2& b, const Vector2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double areaOf(const std::vector<Vector2>& corners) {
  double area = 0.0;
  for (std::size_t i = 2; i < corners.size(); ++i) area += turnOf(corners[0], corners[i - 1], corners[i]);
  return area;
}

/// Whether the triangle at a corner of a counterclockwise polygon is a part of it that contains no other corner.
bool isEar(const std::vector<Vector2>& corners, std::size_t number) {
  const std::size_t count = corners.size();
  const Vector2& a = corners[(number + count - 1) % count];
  const Vector2& b = corners[number];
  const Vector2& c = corners[(number + 1) % count];
  if (turnOf(a, b, c) <= 0.0) return false;
  for (std::size_t i = 2; i + 1 < count; ++i) {
    const Vector2& other = corners[(number + i) % count];
    if (turnOf(a, b, other) >= 0.0 && turnOf(b, c, other) >= 0.0 && turnOf(c, a, other) >= 0.0) return false;
  }
  return true;
}

}  // namespace

ListMarker::ListMarker(const char* kind, int id, marker_style::Layer layer, int type) {
  marker_.header.frame_id = names::MAP_FRAME;  // the stamp stays 0, so that RViz draws the marker at any time
  marker_.ns = kind;
  marker_.id = id;
  marker_.type = type;
  marker_.action = visualization_msgs::Marker::ADD;
  marker_.pose.position.z = static_cast<int>(layer) * marker_style::LAYER_HEIGHT;
  marker_.pose.orientation = toQuaternion(0.0);
  marker_.color.a = 1.0F;
}

void ListMarker::addPoint(const Vector2& position, const Colour& colour) {
  marker_.points.push_back(toPoint(position));
  marker_.colors.push_back(colour);
}

visualization_msgs::Marker ListMarker::finish() {
  if (marker_.points.empty()) marker_.action = visualization_msgs::Marker::DELETE;
  return std::move(marker_);
}

std::vector<Vector2> unitCircle(std::size_t corners) {
  std::vector<Vector2> circle;
  for (std::size_t i = 0; i < corners; ++i) {
    circle.push_back(unitVector(2.0 * PI * static_cast<double>(i) / static_cast<double>(corners)));
  }
  return circle;
}

TriangleMarker::TriangleMarker(const char* kind, int id, marker_style::Layer layer)
    : ListMarker(kind, id, layer, visualization_msgs::Marker::TRIANGLE_LIST) {
  marker_.scale.x = marker_.scale.y = marker_.scale.z = 1.0;
}

void TriangleMarker::addTriangle(const Vector2& a, const Vector2& b, const Vector2& c, const Colour& colour) {
  for (const Vector2* corner : {&a, &b, &c}) addPoint(*corner, colour);
}

void TriangleMarker::addDisc(const Vector2& centre, double radius, const std::vector<Vector2>& circle,
                             const Colour& colour) {
  const auto corner = [&](std::size_t i) -> Vector2 { return centre + radius * circle[i]; };
  for (std::size_t i = 2; i < circle.size(); ++i) addTriangle(corner(0), corner(i - 1), corner(i), colour);
}

void TriangleMarker::addPolygon(std::vector<Vector2> corners, const Colour& colour) {
  if (areaOf(corners) < 0.0) std::reverse(corners.begin(), corners.end());
  for (std::size_t i = 0; corners.size() >= 3 && i < corners.size();) {
    const std::size_t count = corners.size();
    if (!isEar(corners, i)) {
      ++i;
      continue;
    }
    addTriangle(corners[(i + count - 1) % count], corners[i], corners[(i + 1) % count], colour);
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
    i = 0;
  }
}

void TriangleMarker::addArrow(const Pose& pose, double radius, const Colour& colour) {
  using namespace marker_style;  // NOLINT(google-build-using-namespace): the sizes of the arrow
  const Rotation frame(pose.heading);
  const auto corner = [&](double ahead, double left) -> Vector2 {
    return pose.position + frame.outOfFrame(radius * Vector2(ahead, left));
  };
  const Vector2 tip = corner(ARROW_TIP, 0.0);
  const Vector2 notch = corner(ARROW_NOTCH, 0.0);
  addTriangle(tip, corner(ARROW_BACK, ARROW_HALF_WIDTH), notch, colour);
  addTriangle(tip, notch, corner(ARROW_BACK, -ARROW_HALF_WIDTH), colour);
}

void TriangleMarker::addRingPiece(const Vector2& centre, double inner, double outer, const Vector2& from,
                                  const Vector2& to, const Colour& colour) {
  addTriangle(centre + inner * from, centre + outer * from, centre + outer * to, colour);
  if (inner > 0.0) addTriangle(centre + inner * from, centre + outer * to, centre + inner * to, colour);
}

void TriangleMarker::addRing(const Vector2& centre, double inner, double outer, const std::vector<Vector2>& circle,
                             const Colour& colour) {
  for (std::size_t i = 0; i < circle.size(); ++i) {
    addRingPiece(centre, inner, outer, circle[i], circle[(i + 1) % circle.size()], colour);
  }
}

void TriangleMarker::addRingPart(const Vector2& centre, double inner, double outer, double from, double to,
                                 const Colour& colour) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / MAX_TURN)));
  const auto direction = [&](int i) { return unitVector(from + (to - from) * i / pieces); };
  for (int i = 0; i < pieces; ++i) addRingPiece(centre, inner, outer, direction(i), direction(i + 1), colour);
}

LineMarker::LineMarker(const char* kind, int id, marker_style::Layer layer, double width)
    : ListMarker(kind, id, layer, visualization_msgs::Marker::LINE_LIST) {
  marker_.scale.x = width;
}

void LineMarker::addLine(const Vector2& from, const Vector2& to, const Colour& begin, const Colour& end) {
  addPoint(from, begin);
  addPoint(to, end);
}

void LineMarker::addCircle(const Vector2& centre, double radius, const std::vector<Vector2>& circle,
                           const Colour& colour) {
  std::vector<Vector2> corners;
  corners.reserve(circle.size());
  for (const Vector2& corner : circle) corners.emplace_back(centre + radius * corner);
  addPolygon(corners, colour);
}

void LineMarker::addPolygon(const std::vector<Vector2>& corners, const Colour& colour) {
  for (std::size_t i = 0; i < corners.size(); ++i) addLine(corners[i], corners[(i + 1) % corners.size()], colour);
}

void LineMarker::addCross(const Vector2& centre, double size, const Colour& colour) {
  const Vector2 rising = Vector2(1.0, 1.0).normalized() * size;
  const Vector2 falling(rising.x(), -rising.y());
  addLine(centre - rising, centre + rising, colour);
  addLine(centre - falling, centre + falling, colour);
}

}  // namespace crowd
