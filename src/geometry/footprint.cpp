#include "geometry/footprint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crowd {
namespace {

/// Areas and lengths up to this are zero [m], [m^2].
constexpr double TINY = 1e-9;

Vector2 intoFrame(const Pose& pose, const Vector2& point) {
  return Rotation(pose.heading).intoFrame(point - pose.position);
}

/// Edge number i of a polygon, from corner i to the next.
Segment edge(const std::vector<Vector2>& corners, std::size_t i) {
  return {corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]};
}

/// Whether two segments have a common point; false for those on one line, whose ends are then tested by distances.
bool intersect(const Segment& a, const Segment& b) {
  const Vector2 along_a = a.to - a.from;
  const Vector2 along_b = b.to - b.from;
  const double denominator = cross(along_a, along_b);
  if (denominator == 0.0) return false;
  const double share_a = cross(b.from - a.from, along_b) / denominator;
  const double share_b = cross(b.from - a.from, along_a) / denominator;
  return share_a >= 0.0 && share_a <= 1.0 && share_b >= 0.0 && share_b <= 1.0;
}

double distanceBetween(const Segment& a, const Segment& b) {
  if (intersect(a, b)) return 0.0;
  return std::min({distanceTo(a, b.from), distanceTo(a, b.to), distanceTo(b, a.from), distanceTo(b, a.to)});
}

bool isInside(const std::vector<Vector2>& corners, const Vector2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment side = edge(corners, i);
    if ((side.from.y() > point.y()) == (side.to.y() > point.y())) continue;
    const double share = (point.y() - side.from.y()) / (side.to.y() - side.from.y());
    if (point.x() < side.from.x() + share * (side.to.x() - side.from.x())) inside = !inside;
  }
  return inside;
}

/// Distance to a point in the frame of the polygon; negative inside.
double distanceToPoint(const std::vector<Vector2>& corners, const Vector2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) nearest = std::min(nearest, distanceTo(edge(corners, i), point));
  return isInside(corners, point) ? -nearest : nearest;
}

/// Distance to a segment in the frame of the polygon; 0 if they have a common point.
double distanceToSegment(const std::vector<Vector2>& corners, const Segment& segment) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    nearest = std::min(nearest, distanceBetween(edge(corners, i), segment));
  }
  return nearest > 0.0 && isInside(corners, segment.from) ? 0.0 : nearest;
}

}  // namespace

double Footprint::reach() const {
  if (isDisc()) return radius;
  double farthest = 0.0;
  for (const Vector2& corner : corners) farthest = std::max(farthest, corner.norm());
  return farthest;
}

std::vector<Vector2> Footprint::cornersAt(const Pose& pose) const {
  const Rotation frame(pose.heading);
  std::vector<Vector2> placed;
  placed.reserve(corners.size());
  for (const Vector2& corner : corners) placed.emplace_back(pose.position + frame.outOfFrame(corner));
  return placed;
}

double distance(const Footprint& footprint, const Pose& pose, const Vector2& point) {
  if (footprint.isDisc()) return (point - pose.position).norm() - footprint.radius;
  return distanceToPoint(footprint.corners, intoFrame(pose, point));
}

double distance(const Footprint& footprint, const Pose& pose, const Segment& segment) {
  if (footprint.isDisc()) return distanceTo(segment, pose.position) - footprint.radius;
  return distanceToSegment(footprint.corners, {intoFrame(pose, segment.from), intoFrame(pose, segment.to)});
}

bool isCutBy(const Footprint& footprint, const Pose& pose, const Segment& segment, double tolerance) {
  const double apart = distance(footprint, pose, segment);
  return apart < -tolerance || (!footprint.isDisc() && apart <= 0.0);
}

double distance(const Footprint& first, const Pose& first_pose, const Footprint& second, const Pose& second_pose) {
  if (second.isDisc()) return distance(first, first_pose, second_pose.position) - second.radius;
  if (first.isDisc()) return distance(second, second_pose, first_pose.position) - first.radius;
  const std::vector<Vector2> corners = second.cornersAt(second_pose);
  double nearest = distance(second, second_pose, first.cornersAt(first_pose).front());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    nearest = std::min(nearest, distance(first, first_pose, edge(corners, i)));
  }
  return nearest;
}

std::string problemOf(const std::vector<Vector2>& corners) {
  if (corners.size() < 3) return "expected at least 3 corners, got " + std::to_string(corners.size());
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Segment side = edge(corners, i);
    if ((side.to - side.from).norm() < TINY) return "corner " + std::to_string(i) + " and the next are the same";
    area += 0.5 * cross(side.from, side.to);
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t k = i + 2; k < corners.size(); ++k) {
      const bool are_neighbours = i == 0 && k + 1 == corners.size();
      if (are_neighbours || distanceBetween(edge(corners, i), edge(corners, k)) > 0.0) continue;
      return "expected a polygon that does not cross itself, but edges " + std::to_string(i) + "-" +
             std::to_string(i + 1) + " and " + std::to_string(k) + "-" + std::to_string((k + 1) % corners.size()) +
             " cross";
    }
  }
  return std::abs(area) < TINY ? "expected a polygon with an area, got corners on one line" : "";
}

}  // namespace crowd
