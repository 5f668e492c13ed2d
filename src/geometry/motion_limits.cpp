#include "geometry/motion_limits.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"
#include "common/text/numbers.h"
#include "geometry/limits.h"

namespace crowd {
namespace {

constexpr const char* UNLIMITED = "unlimited";
constexpr double LEAST_LIMIT = 0.01;  // of all limits; at 1.3 m/s such brakes take 85 m

/// The last velocity on the way from one to another that is within an angle [rad] of the heading, the x axis. The first
/// one is, unless the agent was pushed; then it may have to stand.
Vector2 withinAngle(const Vector2& from, const Vector2& to, double angle) {
  if (to == Vector2::Zero() || std::abs(bearingOf(to)) <= angle) return to;
  if (angle >= 0.5 * PI) return Vector2::Zero();
  const Vector2 boundary(portable::cos(angle), to.y() < 0.0 ? -portable::sin(angle) : portable::sin(angle));
  const double before = std::abs(cross(boundary, from));
  const double after = std::abs(cross(boundary, to));
  const Vector2 last = from + before / (before + after) * (to - from);
  // Projected, because rounding gives a velocity of almost 0 any direction.
  return std::max(0.0, boundary.dot(last)) * boundary;
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
  const double excess = Vector2(along / most_along, cross(ahead, change) / most_across).norm();
  const Vector2 reached = excess > 1.0 ? Vector2(velocity + change / excess) : wanted;
  return turn_rate < INFINITE ? withinAngle(velocity, reached, turn_rate * tick_duration) : reached;
}

MotionLimits widest(const MotionLimits& a, const MotionLimits& b) {
  return {std::max(a.acceleration, b.acceleration), std::max(a.braking, b.braking), std::max(a.turn_rate, b.turn_rate)};
}

std::string refusalOf(const MotionLimits& motion) {
  const bool are_possible = motion.acceleration >= LEAST_LIMIT && motion.braking >= LEAST_LIMIT &&
                            motion.turn_rate >= LEAST_LIMIT;  // false for NaN
  if (are_possible && (motion.acceleration < INFINITE) == motion.areOn()) return "";
  return "expected acceleration and braking, or neither, of at least " + toText(LEAST_LIMIT) +
         " m/s^2, and a turn_rate of at least " + toText(LEAST_LIMIT) + " rad/s";
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
  const std::string refusal = refusalOf(motion);
  if (!refusal.empty()) throwProblem(place, node, refusal);
  return motion;
}

std::string toText(const MotionLimits& motion) {
  if (!motion.areOn()) return UNLIMITED;
  return "{acceleration: " + toText(motion.acceleration) + ", braking: " + toText(motion.braking) +
         (motion.turn_rate < INFINITE ? ", turn_rate: " + toText(motion.turn_rate) : "") + "}";
}

}  // namespace crowd
