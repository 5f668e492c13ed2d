#include "robots/controllers/orca.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace crowd::orca {
namespace {

constexpr double PARALLEL = 1e-9;  // sine of the angle between lines that count as parallel

Vector2 turnedLeft(const Vector2& v) { return {-v.y(), v.x()}; }

/// The unit vector of a vector; of zero, some other one.
Vector2 directionOf(const Vector2& v, const Vector2& other) {
  const double length = v.norm();
  return length > 0.0 ? Vector2(v / length) : other;
}

/// What is to be made as large as possible: nearness to a velocity, or the component in a direction.
struct Aim {
  Vector2 vector = Vector2::Zero();
  bool is_direction = false;
};

/// The best velocity on the border of a half-plane, in the half-planes before it and in the disc; none if there is
/// none.
std::optional<Vector2> bestOnBorder(const std::vector<HalfPlane>& planes, std::size_t number, double max_speed,
                                    const Aim& aim) {
  const HalfPlane& plane = planes[number];
  const Vector2 along = -turnedLeft(plane.normal);
  const double middle = -plane.point.dot(along);  // of the chord that the disc cuts off, from plane.point
  const double squared = max_speed * max_speed - (plane.point + middle * along).squaredNorm();
  if (squared < 0.0) return std::nullopt;
  double low = middle - std::sqrt(squared);
  double high = middle + std::sqrt(squared);
  for (std::size_t i = 0; i < number; ++i) {
    const double slope = along.dot(planes[i].normal);
    const double outside = (planes[i].point - plane.point).dot(planes[i].normal);
    if (std::abs(slope) <= PARALLEL) {
      if (outside > 0.0) return std::nullopt;
      continue;
    }
    if (slope > 0.0) low = std::max(low, outside / slope);
    if (slope < 0.0) high = std::min(high, outside / slope);
    if (low > high) return std::nullopt;
  }
  const double wanted = aim.is_direction ? (aim.vector.dot(along) > 0.0 ? high : low)
                                         : std::clamp((aim.vector - plane.point).dot(along), low, high);
  return plane.point + wanted * along;
}

bool isIn(const HalfPlane& plane, const Vector2& velocity) { return (velocity - plane.point).dot(plane.normal) >= 0.0; }

/// The best velocity in the first half-planes, as many as have one. Returns their number.
std::size_t solve(const std::vector<HalfPlane>& planes, double max_speed, const Aim& aim, Vector2& velocity) {
  const double length = aim.vector.norm();
  velocity = aim.is_direction || length > max_speed ? Vector2(aim.vector * (max_speed / length)) : aim.vector;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (isIn(planes[i], velocity)) continue;
    const std::optional<Vector2> better = bestOnBorder(planes, i, max_speed, aim);
    if (!better) return i;
    velocity = *better;
  }
  return planes.size();
}

/// The velocities at which a half-plane is violated less than another one, or as much: its border is the set of those
/// with equal depths. None if one of them always is.
std::optional<HalfPlane> lessViolated(const HalfPlane& other, const HalfPlane& plane) {
  const Vector2 difference = other.normal - plane.normal;
  const double length = difference.norm();
  if (length <= PARALLEL) return std::nullopt;
  // (v - other.point) . other.normal >= (v - plane.point) . plane.normal
  const double offset = other.point.dot(other.normal) - plane.point.dot(plane.normal);
  return HalfPlane{difference * (offset / (length * length)), difference / length};
}

/// The velocity that is least deep outside of the half-planes from `first` on, in the fixed ones.
Vector2 leastViolating(const std::vector<HalfPlane>& planes, std::size_t fixed, std::size_t first, double max_speed,
                       Vector2 velocity) {
  double depth = 0.0;
  std::vector<HalfPlane> others;
  for (std::size_t i = first; i < planes.size(); ++i) {
    const HalfPlane& plane = planes[i];
    if ((plane.point - velocity).dot(plane.normal) <= depth) continue;
    others.assign(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(std::min(fixed, i)));
    for (std::size_t j = fixed; j < i; ++j) {
      if (const std::optional<HalfPlane> line = lessViolated(planes[j], plane)) others.push_back(*line);
    }
    Vector2 better;
    if (solve(others, max_speed, {plane.normal, true}, better) == others.size()) velocity = better;
    depth = std::max(depth, (plane.point - velocity).dot(plane.normal));
  }
  return velocity;
}

}  // namespace

HalfPlane avoid(const Neighbour& body, double radius, const Vector2& velocity, double share, double horizon,
                double tick) {
  const double reach = radius + body.radius;
  const double distance = body.position.norm();
  const Vector2 relative = velocity - body.velocity;
  const double time = distance > reach ? horizon : tick;
  const Vector2 centre = body.position / time;
  const Vector2 from_centre = relative - centre;
  Vector2 normal;
  Vector2 change;
  // Below the tangents from the origin to the disc, the nearest point of the boundary is on the disc.
  const double along = from_centre.dot(body.position);
  const bool is_at_disc =
      distance <= reach || (along < 0.0 && along * along > reach * reach * from_centre.squaredNorm());
  if (is_at_disc) {
    normal = directionOf(from_centre, distance > 0.0 ? Vector2(-body.position / distance) : Vector2(-1.0, 0.0));
    change = (reach / time - from_centre.norm()) * normal;
  } else {
    const double leg = std::sqrt(distance * distance - reach * reach);
    const double side = cross(body.position, relative) > 0.0 ? 1.0 : -1.0;  // left or right of the body
    const Vector2 ahead = body.position / distance;
    const Vector2 tangent = (leg * ahead + side * reach * turnedLeft(ahead)) / distance;
    normal = side * turnedLeft(tangent);
    change = relative.dot(tangent) * tangent - relative;
  }
  return {velocity + share * change, normal};
}

HalfPlane avoid(const Segment& wall, double radius, double horizon, double tick) {
  const Vector2 nearest = nearestPoint(wall, Vector2::Zero());
  const Vector2 normal = directionOf(-nearest, {-1.0, 0.0});
  const double room = nearest.norm() - radius;
  return {-normal * (room > 0.0 ? room / horizon : room / tick), normal};
}

Vector2 nearestVelocity(const std::vector<HalfPlane>& planes, std::size_t fixed, double max_speed,
                        const Vector2& wanted) {
  Vector2 velocity;
  const std::size_t solved = solve(planes, max_speed, {wanted, false}, velocity);
  return solved == planes.size() ? velocity : leastViolating(planes, fixed, solved, max_speed, velocity);
}

}  // namespace crowd::orca
