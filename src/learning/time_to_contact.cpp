#include "social_crowd/learning/time_to_contact.h"

#include <algorithm>

namespace crowd {

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
  double time = NEVER;
  for (const PerceivedBody& body : perception.bodies) {
    time = std::min(time, timeToContact(body.position, velocity - body.velocity, radius + body.radius));
  }
  for (const Segment& wall : perception.walls) time = std::min(time, timeToContact(wall, velocity, radius));
  return time;
}

}  // namespace crowd
