#include "scenario/goal_checks.h"

#include <string>

#include "common/text/numbers.h"
#include "maps/occupancy_map.h"
#include "scenario/region_geometry.h"
#include "social_crowd/errors.h"

namespace crowd {

void refuse(const Scenario& scenario, const Label& label, const std::string& problem) {
  throw InputError(scenario.source + ", line " + std::to_string(label.line) + ": " + problem);
}

bool areConnected(const FreeSpace& free_space, const Vector2& from, const Vector2& to) {
  const std::uint32_t component = free_space.component(from);
  return component != FreeSpace::NONE && component == free_space.component(to);
}

void requireWay(const Scenario& scenario, const AgentGroup& group, const Label& label) {
  if (group.route || group.leader) return;
  const bool goal_is_fixed = group.opposite || group.goals.front().isFixed();
  if (!group.position.isFixed() || !goal_is_fixed) return;
  const Vector2& start = group.position.first;
  const Vector2 goal = group.opposite ? Vector2(2.0 * *group.opposite - start) : group.goals.front().first;
  const double distance = (goal - start).norm();
  if (distance > scenario.goal_tolerance) return;
  refuse(scenario, label,
         label.text() + ": its goal is " + toText(distance) + " m from its start, within goal_tolerance (" +
             toText(scenario.goal_tolerance) + " m)");
}

bool comesNear(const Vector2& goal, double radius, double tolerance, const Scenario& scenario,
               const PlacedBodies& placed) {
  if (!placed.canStandAt(goal, radius - tolerance)) return false;
  if (!scenario.map) return true;
  const Cell cell = CellFrame(*scenario.map).cellAt(goal);
  const bool is_blocked = scenario.map->contains(cell) && !scenario.map->isFree(cell);
  return !is_blocked || !placed.canStandAt(goal, tolerance - radius);
}

namespace {

class GoalCheck {
 public:
  GoalCheck(const Scenario& scenario, const PlacedBodies& placed) : scenario_(scenario), placed_(placed) {}

  /// @param field such as agents[0].goal
  void require(const Vector2& goal, const AgentGroup& group, const std::string& field) const {
    const double radius = group.radius.high;
    if (comesNear(goal, radius, scenario_.goal_tolerance, scenario_, placed_)) return;
    throw InputError(scenario_.source + ", line " + std::to_string(group.line) + ": " + field +
                     ": expected a goal that an agent of radius " + toText(radius) +
                     " m can get to within goal_tolerance (" + toText(scenario_.goal_tolerance) + " m), got " +
                     placeText(goal) + ", which is in a wall or an obstacle");
  }

 private:
  const Scenario& scenario_;
  const PlacedBodies& placed_;
};

}  // namespace

void requireFreeGoals(const Scenario& scenario, const PlacedBodies& placed) {
  if (!scenario.way_finding) return;
  const GoalCheck check(scenario, placed);
  for (std::size_t entry = 0; entry < scenario.agents.size(); ++entry) {
    const AgentGroup& group = scenario.agents[entry];
    const std::string name = "agents[" + std::to_string(entry) + "]";
    for (std::size_t i = 0; i < group.goals.size(); ++i) {
      const std::string field = group.goals.size() == 1 ? ".goal" : ".goals[" + std::to_string(i) + "]";
      if (group.goals[i].isFixed()) check.require(group.goals[i].first, group, name + field);
    }
    if (!group.opposite || !group.position.isFixed()) continue;
    check.require(2.0 * *group.opposite - group.position.first, group, name + ".goal");
  }
}

}  // namespace crowd
