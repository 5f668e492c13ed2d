#include "world/placed_bodies.h"

#include <algorithm>

#include "social_crowd/world/scene.h"

namespace crowd {

std::optional<Blocker> PlacedBodies::findBlocker(const Vector2& centre, double radius, double gap) const {
  for (const Body& body : bodies_) {
    const double depth = radius + body.radius - (body.centre - centre).norm();
    if (depth > -gap) {
      return Blocker{body.label.text(), depth};
    }
  }
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const double depth = radius - distanceTo(walls_[i], centre);
    if (depth > -gap) {
      return Blocker{"walls[" + std::to_string(i) + "]", depth};
    }
  }
  return std::nullopt;
}

std::optional<Blocker> PlacedBodies::findBlocker(const Footprint& footprint, const Pose& pose) const {
  for (const Body& body : bodies_) {
    const double depth = body.radius - distance(footprint, pose, body.centre);
    if (!body.is_robot && depth > TOUCH_TOLERANCE) return Blocker{body.label.text(), depth};
  }
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (!isCutBy(footprint, pose, walls_[i], TOUCH_TOLERANCE)) continue;
    return Blocker{"walls[" + std::to_string(i) + "]", -distance(footprint, pose, walls_[i])};
  }
  return std::nullopt;
}

bool PlacedBodies::isNearGoal(const Vector2& centre, double radius) const {
  return std::any_of(goals_.begin(), goals_.end(),
                     [&](const Goal& goal) { return (goal.point - centre).norm() < radius + goal.radius; });
}

bool PlacedBodies::canStandAt(const Vector2& point, double radius) const {
  const bool body = std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& other) {
    return other.at_rest && (other.centre - point).norm() < radius + other.radius;
  });
  return !body && std::none_of(walls_.begin(), walls_.end(),
                               [&](const Segment& wall) { return distanceTo(wall, point) < radius; });
}

}  // namespace crowd
