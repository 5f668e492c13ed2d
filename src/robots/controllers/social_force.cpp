#include "robots/controllers/social_force.h"

#include <algorithm>
#include <cmath>

#include "common/portable_math.h"

namespace crowd::social_force {
namespace {

constexpr double LEAST_DISTANCE = 0.01;  // between rims, for the direction of a force [m]

}  // namespace

Vector2 drivingForce(const Vector2& velocity, const Vector2& wanted) { return (wanted - velocity) / RELAXATION_TIME; }

Vector2 bodyForce(const Neighbour& body, double radius) {
  const double centres = body.position.norm();
  const Vector2 away = centres > 0.0 ? Vector2(-body.position / centres) : Vector2(-1.0, 0.0);
  const Vector2 from_body = std::max(LEAST_DISTANCE, centres - radius - body.radius) * away;
  const Vector2 step = STEP_TIME * body.velocity;
  const Vector2 from_step = from_body - step;
  const double near = from_body.norm();
  const double far = from_step.norm();
  const double sum = near + far;
  const double semi_axis = 0.5 * std::sqrt(std::max(0.0, sum * sum - step.squaredNorm()));
  if (far < LEAST_DISTANCE || semi_axis < LEAST_DISTANCE) return REPULSION / RANGE * away;  // it is on its way
  const Vector2 gradient = sum / (4.0 * semi_axis) * (from_body / near + from_step / far);
  return REPULSION / RANGE * portable::exp(-semi_axis / RANGE) * gradient;
}

Vector2 wallForce(const Segment& wall) {
  const Vector2 away = -nearestPoint(wall, Vector2::Zero());
  const double distance = std::max(LEAST_DISTANCE, away.norm());
  return WALL_REPULSION / WALL_RANGE * portable::exp(-distance / WALL_RANGE) / distance * away;
}

double sightWeight(const Vector2& direction, const Vector2& force) {
  return -direction.dot(force) >= portable::cos(SIGHT) * direction.norm() * force.norm() ? 1.0 : UNSEEN_SHARE;
}

}  // namespace crowd::social_force
