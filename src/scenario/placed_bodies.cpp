#include "scenario/placed_bodies.h"

#include <algorithm>

#include "geometry/closest_points.h"
#include "geometry/impact.h"
#include "scenario/scene.h"

namespace crowd {

std::optional<Blocker> PlacedBodies::findBlocker(const Vector2& centre, double radius, double gap) const {
  const auto depth_of = [&](std::size_t number) {
    return radius + discs_[number].radius - (discs_[number].centre - centre).norm();
  };
  const std::size_t body =
      discs_.findFirst(centre, radius + gap, [&](std::size_t number) { return depth_of(number) > -gap; });
  if (body != DiscBuckets::NONE) return Blocker{bodies_[body].label.text(), depth_of(body)};
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const double depth = radius - distanceTo(walls_[i], centre);
    if (depth > -gap) {
      return Blocker{"walls[" + std::to_string(i) + "]", depth};
    }
  }
  return std::nullopt;
}

std::optional<Blocker> PlacedBodies::findBlocker(const Footprint& footprint, const Pose& pose) const {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const double depth = discs_[i].radius - distance(footprint, pose, discs_[i].centre);
    if (!bodies_[i].is_robot && depth > TOUCH_TOLERANCE) return Blocker{bodies_[i].label.text(), depth};
  }
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (!isCutBy(footprint, pose, walls_[i], TOUCH_TOLERANCE)) continue;
    return Blocker{"walls[" + std::to_string(i) + "]", -distance(footprint, pose, walls_[i])};
  }
  return std::nullopt;
}

bool PlacedBodies::isNearGoal(const Vector2& centre, double radius) const {
  return goals_.isAnyNear(centre, radius, [&](std::size_t number) {
    return (goals_[number].centre - centre).norm() < radius + goals_[number].radius;
  });
}

bool PlacedBodies::canWalkBetween(const Vector2& from, const Vector2& to) const {
  return std::none_of(walls_.begin(), walls_.end(), [&](const Segment& wall) {
    const ClosestPoints points = closestPoints(wall, {from, to});
    return (points.of_first - points.of_second).norm() <= TOUCH_TOLERANCE;
  });
}

bool PlacedBodies::canStandAt(const Vector2& point, double radius) const {
  const bool body = discs_.isAnyNear(point, radius, [&](std::size_t number) {
    return bodies_[number].at_rest && (discs_[number].centre - point).norm() < radius + discs_[number].radius;
  });
  return !body && std::none_of(walls_.begin(), walls_.end(),
                               [&](const Segment& wall) { return distanceTo(wall, point) < radius; });
}

}  // namespace crowd
