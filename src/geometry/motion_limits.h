#pragma once

#include <string>

#include "common/text/yaml_reader.h"
#include "geometry/geometry.h"

namespace crowd {

/// @brief How fast agents change their velocity, as bodies with mass do (docs/separation_rule.md, Mass). Unlimited by
/// default: an agent has any velocity, up to its maximum speed, in the next tick.
struct MotionLimits {
  double acceleration = INFINITE;  ///< when it speeds up or swerves [m/s2]; infinite if and only if `braking` is
  double braking = INFINITE;       ///< when it slows down [m/s2]
  double turn_rate = INFINITE;     ///< of the heading, the direction of motion [rad/s]

  /// @brief Whether there are limits.
  bool areOn() const { return braking < INFINITE; }
  /// @brief Upper bound of the displacement until it stands, if it brakes from a velocity [m].
  Vector2 stoppingWay(const Vector2& velocity) const { return velocity.norm() / (2.0 * braking) * velocity; }
  /// @brief Upper bound of the way of a tick at a speed, and until it stands afterwards [m].
  double reach(double speed, double tick_duration) const {
    return speed * tick_duration + speed * speed / (2.0 * braking);
  }
  /// @brief The velocity after it has braked for one tick [m/s].
  Vector2 braked(const Vector2& velocity, double tick_duration) const;
  /// @brief The velocity that it can have after a tick which is the nearest to a wanted one, on the line between the
  /// present and the wanted one [m/s].
  /// @param velocity the present one, in a frame whose x axis is the heading
  Vector2 reachable(const Vector2& velocity, const Vector2& wanted, double tick_duration) const;
};

inline bool operator==(const MotionLimits& a, const MotionLimits& b) {
  return a.acceleration == b.acceleration && a.braking == b.braking && a.turn_rate == b.turn_rate;
}

/// @brief Limits that permit what either of both permits.
MotionLimits widest(const MotionLimits& a, const MotionLimits& b);

/// @brief What is wrong with limits that a file, a message or a caller gives; empty: nothing.
std::string refusalOf(const MotionLimits& motion);

/// @brief Reads the value of the key `motion`: a map with `acceleration`, `braking` and, optionally, `turn_rate`
/// [rad/s], or the word `unlimited`. @throws InputError
MotionLimits readMotionLimits(const YAML::Node& node, const YamlPlace& place);
/// @brief Inverse of readMotionLimits().
std::string toText(const MotionLimits& motion);

}  // namespace crowd
