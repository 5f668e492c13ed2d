#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include "common/portable_math.h"

namespace crowd {

/// @brief Points and vectors of the ground plane [m]; x forward or east, y left or north (REP 103).
using Vector2 = Eigen::Vector2d;

constexpr double PI = 3.14159265358979323846;

/// @brief Position [m] and heading [rad] (counterclockwise, 0 along x) of a body.
struct Pose {
  Vector2 position = Vector2::Zero();
  double heading = 0.0;
};

constexpr double INFINITE = std::numeric_limits<double>::infinity();

/// @brief A straight wall segment between two points [m].
struct Segment {
  Vector2 from = Vector2::Zero();
  Vector2 to = Vector2::Zero();
};

constexpr double toRadians(double degrees) { return degrees * (PI / 180.0); }
constexpr double toDegrees(double radians) { return radians * (180.0 / PI); }

/// @brief Normalizes an angle [rad] to [-pi, pi).
inline double wrapAngle(double angle) {
  // Up to 2.5 pi these differences are exact. No branch depends on the sign of the angle.
  if (std::abs(angle) < 2.5 * PI) return angle - (angle >= PI ? 2.0 * PI : 0.0) - (angle < -PI ? -2.0 * PI : 0.0);
  const double wrapped = std::remainder(angle, 2.0 * PI);
  return wrapped >= -PI && wrapped < PI ? wrapped : -PI;
}

/// @brief Direction of a vector [rad], in [-pi, pi]; 0 for the zero vector.
inline double bearingOf(const Vector2& v) { return portable::atan2(v.y(), v.x()); }

/// @brief Unit vector in the direction of a heading [rad].
inline Vector2 unitVector(double heading) { return {portable::cos(heading), portable::sin(heading)}; }

/// @brief z component of the cross product: positive if b lies to the left of a.
inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// @brief Rotation between `map` and a frame turned by a heading; stores sine and cosine.
class Rotation {
 public:
  explicit Rotation(double heading) : Rotation(unitVector(heading)) {}
  /// @param ahead unit vector of the heading
  explicit Rotation(const Vector2& ahead) : ahead_(ahead), left_(-ahead.y(), ahead.x()) {}
  /// @brief Transforms a vector from `map` into the turned frame.
  Vector2 intoFrame(const Vector2& v) const {
    return v.x() * Vector2(ahead_.x(), left_.x()) + v.y() * Vector2(ahead_.y(), left_.y());
  }
  /// @brief Transforms a vector from the turned frame into `map`.
  Vector2 outOfFrame(const Vector2& v) const { return v.x() * ahead_ + v.y() * left_; }

 private:
  Vector2 ahead_;  // axes of the turned frame in `map`
  Vector2 left_;
};

/// @brief The point of a segment nearest to p [m].
inline Vector2 nearestPoint(const Segment& segment, const Vector2& p) {
  const Vector2 along = segment.to - segment.from;
  const double length_squared = along.squaredNorm();
  if (length_squared <= 0.0) return segment.from;
  const double share = std::clamp((p - segment.from).dot(along) / length_squared, 0.0, 1.0);
  return segment.from + share * along;
}

/// @brief Distance from p to the segment [m].
inline double distanceTo(const Segment& segment, const Vector2& p) { return (nearestPoint(segment, p) - p).norm(); }

}  // namespace crowd
