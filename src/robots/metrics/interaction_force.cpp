#include "robots/metrics/interaction_force.h"

#include "common/portable_math.h"

namespace crowd {
namespace {

// Parameters of lightsfm.
constexpr double SOCIAL_FACTOR = 2.1;     // A [m/s^2]
constexpr double VELOCITY_WEIGHT = 2.0;   // lambda [s/m]
constexpr double RANGE_FACTOR = 0.35;     // gamma [m]
constexpr double SLOWING = 3.0;           // n' [1/m]
constexpr double TURNING = 2.0;           // n [1/m]
constexpr double OBSTACLE_FACTOR = 10.0;  // [m/s^2]
constexpr double OBSTACLE_RANGE = 0.2;    // [m]

double square(double value) { return value * value; }

}  // namespace

Vector2 interactionForce(const ForceBody& on, const ForceBody& from) {
  const Vector2 way = from.position - on.position;
  const double apart = way.norm();
  if (apart <= 0.0) return Vector2::Zero();
  const Vector2 interaction = VELOCITY_WEIGHT * (on.velocity - from.velocity) + way / apart;
  const double strength = interaction.norm();
  if (strength <= 0.0) return Vector2::Zero();  // its range is 0
  const Vector2 ahead = interaction / strength;
  const double range = RANGE_FACTOR * strength;
  const double angle = wrapAngle(bearingOf(way) - bearingOf(ahead));
  const double slowing = -portable::exp(-apart / range - square(SLOWING * range * angle));
  const double turning = -portable::exp(-apart / range - square(TURNING * range * angle));
  const double side = angle == 0.0 ? 0.0 : std::copysign(1.0, angle);
  return SOCIAL_FACTOR * (slowing * ahead + side * turning * Vector2(-ahead.y(), ahead.x()));
}

double obstacleForce(double clearance) { return OBSTACLE_FACTOR * portable::exp(-clearance / OBSTACLE_RANGE); }

}  // namespace crowd
