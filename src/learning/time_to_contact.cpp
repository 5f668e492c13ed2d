#include "social_crowd/learning/time_to_contact.h"

#include <algorithm>

#include "social_crowd/common/vectorised.h"

namespace crowd {
namespace {

constexpr std::size_t LANES = PerceivedBodies::MARGIN;
using Times = Eigen::Array<double, LANES, 1>;

/// timeToContact() for `count` bodies from a number on, up to LANES of them; NEVER in the lanes behind these.
CROWD_VECTORISED void findTimes(const PerceivedBodiesView& bodies, std::size_t first, std::size_t count,
                                const Vector2& velocity, double radius, Times& times) {
  const double* const xs = bodies.xs() + first;
  const double* const ys = bodies.ys() + first;
  const double* const vxs = bodies.vxs() + first;
  const double* const vys = bodies.vys() + first;
  const double* const radii = bodies.radii() + first;
  const double vx = velocity.x();
  const double vy = velocity.y();
  const auto end = static_cast<std::int64_t>(count);
  for (std::size_t i = 0; i < LANES; ++i) {
    const double rx = vx - vxs[i];
    const double ry = vy - vys[i];
    const double reach = radius + radii[i];
    const double closing = xs[i] * rx + ys[i] * ry;
    const double apart = (xs[i] * xs[i] + ys[i] * ys[i]) - reach * reach;
    const double square = rx * rx + ry * ry;
    const double inside = closing * closing - square * apart;
    const double met = (closing - std::sqrt(inside)) / square;
    const double ahead = inside < 0.0 ? NEVER : met;
    const double closer = apart <= 0.0 ? 0.0 : ahead;
    const double time = closing <= 0.0 ? NEVER : closer;
    const bool counts = (static_cast<std::int64_t>(i) < end) & (time < NEVER);  // what is not a number does not
    times[i] = counts ? time : NEVER;
  }
}

}  // namespace

double timeToContact(const Segment& wall, const Vector2& velocity, double radius) {
  const double ends = std::min(timeToContact(wall.from, velocity, radius), timeToContact(wall.to, velocity, radius));
  const Vector2 along = (wall.to - wall.from).normalized();
  Vector2 normal(-along.y(), along.x());
  if (normal.dot(wall.from) < 0.0) normal = -normal;
  const double closing = normal.dot(velocity);
  if (closing <= 0.0) return ends;
  const double reached = std::max(0.0, (normal.dot(wall.from) - radius) / closing);
  const double foot = (reached * velocity - wall.from).dot(along);  // of the disc's centre then, along the wall
  const bool beside = foot >= 0.0 && foot <= (wall.to - wall.from).norm();
  return beside ? std::min(ends, reached) : ends;
}

double timeToContact(const Perception& perception, const Vector2& velocity) {
  const double radius = perception.self.radius;
  alignas(64) Times times;
  double time = NEVER;
  for (std::size_t i = 0; i < perception.bodies.size(); i += LANES) {
    findTimes(perception.bodies, i, perception.bodies.size() - i, velocity, radius, times);
    time = std::min(time, times.minCoeff());
  }
  for (const Segment& wall : perception.walls) time = std::min(time, timeToContact(wall, velocity, radius));
  return time;
}

}  // namespace crowd
