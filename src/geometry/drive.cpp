#include "geometry/drive.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd {
namespace {

/// The vector, shortened to a length.
Vector2 shortenedTo(double length, const Vector2& vector) {
  const double norm = vector.norm();
  return norm > length ? Vector2(length / norm * vector) : vector;
}

/// The twist without what the drive cannot do.
Twist feasible(Drive drive, const DriveLimits& limits, Twist twist) {
  if (drive != Drive::HOLONOMIC) twist.linear.y() = 0.0;
  if (drive != Drive::ACKERMANN) return twist;
  const double fastest = std::abs(twist.linear.x()) / limits.min_turning_radius;
  twist.rotation = std::clamp(twist.rotation, -fastest, fastest);
  return twist;
}

/// sin(x) / x.
double sinc(double x) { return std::abs(x) < 1e-4 ? 1.0 - x * x / 6.0 : portable::sin(x) / x; }

}  // namespace

bool Twist::isFinite() const {
  return std::isfinite(linear.x()) && std::isfinite(linear.y()) && std::isfinite(rotation);
}

Twist limitTwist(Drive drive, const DriveLimits& limits, const Twist& last, const Twist& wanted, double tick_duration) {
  Twist twist = feasible(drive, limits, wanted);
  twist.linear = shortenedTo(limits.max_speed, twist.linear);
  twist.rotation = std::clamp(twist.rotation, -limits.max_rotation, limits.max_rotation);
  const double turn = limits.max_rotation_acceleration * tick_duration;
  twist.linear = last.linear + shortenedTo(limits.max_acceleration * tick_duration, twist.linear - last.linear);
  twist.rotation = last.rotation + std::clamp(twist.rotation - last.rotation, -turn, turn);
  return feasible(drive, limits, twist);
}

Pose drivePose(const Pose& pose, const Twist& twist, double time) {
  // The chord of the arc has the direction of its middle.
  const double half = 0.5 * twist.rotation * time;
  const Vector2 chord = sinc(half) * time * Rotation(pose.heading + half).outOfFrame(twist.linear);
  return {pose.position + chord, wrapAngle(pose.heading + 2.0 * half)};
}

Twist twistBetween(const Pose& from, const Pose& to, double time) {
  const double half = 0.5 * wrapAngle(to.heading - from.heading);
  const Vector2 chord = Rotation(from.heading + half).intoFrame(to.position - from.position);
  return {chord / (sinc(half) * time), 2.0 * half / time};
}

double deviation(const DriveLimits& limits, double tick_duration) {
  const double by_limits =
      tick_duration * tick_duration * (limits.max_acceleration + 0.5 * limits.max_speed * limits.max_rotation);
  return std::min(2.0 * limits.max_speed * tick_duration, by_limits);
}

}  // namespace crowd
