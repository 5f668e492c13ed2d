#include "robots/metrics/group_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crowd {
namespace {

constexpr double IN_FRONT = 1.5;  // of a member, where HuNavEval expects the middle of the group [m]

/// The corners of the convex hull, counterclockwise (Andrew's monotone chain); two for points on one line, one for
/// points at the same place.
std::vector<Vector2> hullOf(std::vector<Vector2> points) {
  std::sort(points.begin(), points.end(),
            [](const Vector2& a, const Vector2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vector2> corners;
  const auto add_chain = [&](auto first, auto last) {
    const std::size_t begin = corners.size();
    for (; first != last; ++first) {
      while (corners.size() >= begin + 2 &&
             cross(corners.back() - corners[corners.size() - 2], *first - corners.back()) <= 0.0) {
        corners.pop_back();
      }
      corners.push_back(*first);
    }
    corners.pop_back();  // it begins the next chain
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return corners;
}

bool follows(GroupId group, RobotId robot) { return group == groupOf({Leader::Kind::ROBOT, robot}); }

}  // namespace

void GroupSpaces::observe(const ObservedScene& scene) {
  groups_.clear();
  for (const ObservedPerson& person : scene.people) {
    if (person.group == NO_GROUP) continue;
    auto group = std::find_if(groups_.begin(), groups_.end(), [&](const Group& one) { return one.id == person.group; });
    if (group == groups_.end()) group = groups_.insert(group, Group{person.group, Vector2::Zero(), {}});
    group->middle += person.position + IN_FRONT * unitVector(person.heading);
    group->places.push_back(person.position);
  }
  groups_.erase(std::remove_if(groups_.begin(), groups_.end(), [](const Group& one) { return one.places.size() < 2; }),
                groups_.end());
  for (Group& group : groups_) {
    group.middle /= static_cast<double>(group.places.size());
    group.places = hullOf(std::move(group.places));
  }
}

double GroupSpaces::distanceFrom(const Robot& robot, RobotId id) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Group& group : groups_) {
    if (!follows(group.id, id)) nearest = std::min(nearest, distance(robot.start.footprint, robot.pose, group.middle));
  }
  return std::isinf(nearest) ? std::nan("") : nearest;
}

bool GroupSpaces::isInside(const Robot& robot, RobotId id) const {
  const Footprint& footprint = robot.start.footprint;
  return std::any_of(groups_.begin(), groups_.end(), [&](const Group& group) {
    if (follows(group.id, id)) return false;
    if (group.places.size() < 3) {
      return distance(footprint, robot.pose, Segment{group.places.front(), group.places.back()}) <= 0.0;
    }
    return distance(footprint, robot.pose, Footprint{0.0, group.places}, Pose()) <= 0.0;
  });
}

}  // namespace crowd
