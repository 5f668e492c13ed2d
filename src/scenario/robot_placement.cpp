#include "scenario/robot_placement.h"

#include <algorithm>
#include <string>

#include "common/text/numbers.h"
#include "geometry/impact.h"
#include "scenario/goal_checks.h"
#include "scenario/region_geometry.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

constexpr int MAX_GOAL_TRIES = 100;  // draws of a goal on the map before the whole robot is drawn again

class RobotPlacement {
 public:
  RobotPlacement(const Scenario& scenario, KeyedRandom& random, PlacedBodies& placed, Scene& scene)
      : scenario_(scenario), random_(random), placed_(placed), scene_(scene) {}

  void place(std::size_t index) {
    const RobotGroup& group = scenario_.robots[index];
    const Label label{"robots", index, group.line, 1, 1};
    requireGoals(group, label);
    for (int tries = 0; tries < MAX_TRIES; ++tries) {
      RobotStart robot = draw(group);
      const std::string problem = problemOf(robot, group, index);
      if (problem.empty()) {
        placed_.addRobot(label, robot.position, robot.footprint.reach());
        scene_.robots[index] = std::move(robot);
        return;
      }
      const bool is_fixed = group.position.isFixed() && (!group.heading || group.heading->isFixed());
      const bool are_goals_fixed =
          std::all_of(group.goals.begin(), group.goals.end(), [](const Region& goal) { return goal.isFixed(); });
      if (is_fixed && are_goals_fixed) refuse(scenario_, label, label.text() + " " + problem);
    }
    refuse(scenario_, label,
           label.text() + ": no free place for it and its goal found in " + std::to_string(MAX_TRIES) + " tries");
  }

 private:
  RobotStart draw(const RobotGroup& group) {
    RobotStart robot = group.start;
    robot.position = group.position.draw(random_, scene_.free_space.get());
    for (std::size_t i = 0; i < group.goals.size(); ++i) {
      robot.goals.push_back(drawGoal(group, i, i == 0 ? robot.position : robot.goals.back()));
    }
    if (group.heading) {
      robot.heading = wrapAngle(group.heading->draw(random_));
    } else if (!robot.goals.empty()) {
      robot.heading = bearingOf(robot.goals.front() - robot.position);
    }
    return robot;
  }

  /// A goal anywhere on the map is drawn until it can be reached: a robot with many goals would find no place
  /// otherwise.
  Vector2 drawGoal(const RobotGroup& group, std::size_t i, const Vector2& from) {
    const Region& region = group.goals[i];
    Vector2 goal = region.draw(random_, scene_.free_space.get());
    for (int tries = 1; region.kind == Region::Kind::FREE && tries < MAX_GOAL_TRIES; ++tries) {
      if (placed_.canStandAt(goal, group.start.footprint.reach()) && areConnected(from, goal, group, i)) break;
      goal = region.draw(random_, scene_.free_space.get());
    }
    return goal;
  }

  /// Fixed goals at which the robot does not fit whatever its heading.
  void requireGoals(const RobotGroup& group, const Label& label) const {
    for (std::size_t i = 0; i < group.goals.size(); ++i) {
      const Region& goal = group.goals[i];
      if (!goal.isFixed() || fitsNear(goal.first, group.start)) continue;
      const std::string field = group.goals.size() == 1 ? ".goal" : ".goals[" + std::to_string(i) + "]";
      refuse(scenario_, label,
             label.text() + field + ": a robot of this footprint does not fit at " + placeText(goal.first));
    }
  }

  /// Whether the disc within the footprint fits within the goal tolerance of a goal.
  bool fitsNear(const Vector2& goal, const RobotStart& robot) const {
    const double inner = std::max(0.0, -distance(robot.footprint, Pose(), Vector2(0.0, 0.0)));
    return comesNear(goal, inner, robot.goal_tolerance, scenario_, placed_);
  }

  /// What is wrong with a drawn robot; empty if nothing is.
  std::string problemOf(const RobotStart& robot, const RobotGroup& group, std::size_t index) const {
    std::string blocker = blockerOf(robot, group, index);
    if (!blocker.empty()) return blocker;
    Vector2 from = robot.position;
    for (std::size_t i = 0; i < robot.goals.size(); ++i) {
      const Vector2& goal = robot.goals[i];
      if (i == 0 && (goal - from).norm() <= robot.goal_tolerance) {
        return "starts within goal_tolerance (" + toText(robot.goal_tolerance) + " m) of its goal";
      }
      if (!group.goals[i].isFixed() && !placed_.canStandAt(goal, robot.footprint.reach())) return "has no place";
      if (!areConnected(from, goal, group, i)) return "has no way to its goal";
      from = goal;
    }
    return "";
  }

  /// Places that are drawn anywhere on the map must be connected with those before.
  bool areConnected(const Vector2& from, const Vector2& goal, const RobotGroup& group, std::size_t i) const {
    const Region& before = i == 0 ? group.position : group.goals[i - 1];
    if (before.kind != Region::Kind::FREE && group.goals[i].kind != Region::Kind::FREE) return true;
    return crowd::areConnected(*scene_.free_space, from, goal);
  }

  std::string blockerOf(const RobotStart& robot, const RobotGroup& group, std::size_t index) const {
    const double reach = robot.footprint.reach();
    if (!group.position.isFixed()) {
      return placed_.findBlocker(robot.position, reach, DRAWN_GAP) ? "is too near to something" : "";
    }
    const Pose pose{robot.position, robot.heading};
    if (const auto blocker = placed_.findBlocker(robot.footprint, pose)) return overlapWith(*blocker);
    for (std::size_t i = 0; i < index; ++i) {
      const RobotStart& other = scene_.robots[i];
      if (!scenario_.robots[i].position.isFixed()) continue;
      const double apart = distance(robot.footprint, pose, other.footprint, {other.position, other.heading});
      if (apart < -TOUCH_TOLERANCE || (apart <= 0.0 && !robot.footprint.isDisc())) {
        return overlapWith({"robots[" + std::to_string(i) + "]", -apart});
      }
    }
    return "";
  }

  static std::string overlapWith(const Blocker& blocker) {
    const std::string text = overlapText("", blocker.name, blocker.depth);
    return blocker.depth > 0.0 ? text.substr(1) : "overlaps " + blocker.name;
  }

  const Scenario& scenario_;
  KeyedRandom& random_;
  PlacedBodies& placed_;
  Scene& scene_;
};

}  // namespace

void placeRobots(const Scenario& scenario, bool fixed, KeyedRandom& random, PlacedBodies& placed, Scene& scene) {
  scene.robots.resize(scenario.robots.size());
  RobotPlacement placement(scenario, random, placed, scene);
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    if (scenario.robots[i].position.isFixed() == fixed) placement.place(i);
  }
}

}  // namespace crowd
