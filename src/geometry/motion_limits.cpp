#include "geometry/motion_limits.h"

#include <algorithm>
#include <cmath>

#include "common/text/numbers.h"
#include "geometry/limits.h"

namespace crowd {
namespace {

constexpr const char* UNLIMITED = "unlimited";

/// The last point of the way from `from`, on the x axis, to `to` that is within an angle [rad] of the x axis.
Vector2 withinAngle(const Vector2& from, const Vector2& to, double angle) {
  if (std::abs(bearingOf(to)) <= angle) return to;
  if (angle >= 0.5 * PI) return {0.0, 0.0};  // it stands before it goes on in another direction
  const double side = to.y() < 0.0 ? -1.0 : 1.0;
  const Vector2 outward(-std::sin(angle), side * std::cos(angle));  // across the boundary on the side of `to`
  const double before = -outward.dot(from);
  return from + std::clamp(before / (before + outward.dot(to)), 0.0, 1.0) * (to - from);
}

}  // namespace

Vector2 MotionLimits::braked(const Vector2& velocity, double tick_duration) const {
  const double speed = velocity.norm();
  const double lost = braking * tick_duration;
  return speed <= lost ? Vector2::Zero() : Vector2((1.0 - lost / speed) * velocity);
}

Vector2 MotionLimits::reachable(const Vector2& velocity, const Vector2& wanted, double tick_duration) const {
  if (!areOn()) return wanted;
  const Vector2 change = wanted - velocity;
  const double speed = velocity.norm();
  const Vector2 ahead = speed > 0.0 ? Vector2(velocity / speed) : Vector2::UnitX();
  // What can be reached is half of a disc of faster and half of an ellipse of slower velocities.
  const double along = ahead.dot(change);
  const double most_along = tick_duration * (along < 0.0 && speed > 0.0 ? braking : acceleration);
  const double most_across = tick_duration * acceleration;
  const double excess = std::hypot(along / most_along, cross(ahead, change) / most_across);
  const Vector2 reached = excess > 1.0 ? Vector2(velocity + change / excess) : wanted;
  return withinAngle(velocity, reached, turn_rate * tick_duration);
}

MotionLimits widest(const MotionLimits& a, const MotionLimits& b) {
  return {std::max(a.acceleration, b.acceleration), std::max(a.braking, b.braking), std::max(a.turn_rate, b.turn_rate)};
}

MotionLimits readMotionLimits(const YAML::Node& node, const YamlPlace& place) {
  if (node.IsScalar()) {
    if (node.Scalar() == UNLIMITED) return {};
    throwExpected(place, node, "a map with acceleration and braking, or unlimited");
  }
  const YamlMap map(node, place, {"acceleration", "braking", "turn_rate"});
  MotionLimits motion;
  motion.acceleration = map.number("acceleration", limits::ACCELERATION);
  motion.braking = map.number("braking", limits::ACCELERATION);
  if (map.has("turn_rate")) motion.turn_rate = map.number("turn_rate", limits::ROTATION);
  return motion;
}

std::string toText(const MotionLimits& motion) {
  if (!motion.areOn()) return UNLIMITED;
  return "{acceleration: " + toText(motion.acceleration) + ", braking: " + toText(motion.braking) +
         (motion.turn_rate < INFINITE ? ", turn_rate: " + toText(motion.turn_rate) : "") + "}";
}

}  // namespace crowd
