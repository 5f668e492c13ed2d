#pragma once

#include <cstddef>
#include <vector>

#include "robots/metrics/observed_scene.h"

namespace crowd {

/// @brief The places of people who walk together, at least two, by group.
class GroupSpaces {
 public:
  /// @brief Finds the groups of a scene at the end of a tick.
  void observe(const ObservedScene& scene);

  /// @brief Distance from a robot's footprint to the nearest middle of a group, which HuNavEval uses: the mean of the
  /// points 1.5 m in front of its members [m]; NaN without groups. Those who follow the robot are no group.
  double distanceFrom(const Robot& robot, RobotId id) const;
  /// @brief Whether a robot's footprint has a point in common with the convex hull of the centres of a group.
  bool isInside(const Robot& robot, RobotId id) const;

 private:
  struct Group {
    GroupId id = NO_GROUP;
    Vector2 middle = Vector2::Zero();  // sum of the points in front of them, then their mean
    std::vector<Vector2> places;       // of all members, then the corners of their hull, counterclockwise
  };

  std::vector<Group> groups_;
};

}  // namespace crowd
