#include "learning/actions/action_set.h"

#include "learning/actions/goal_relative_actions.h"
#include "learning/actions/kings_moves.h"

namespace crowd {

const std::vector<ActionSetType>& actionSetTypes() {
  static const std::vector<ActionSetType> TYPES = {
      {KingsMoves::TYPE, "the thesis's moves: a rotation by a multiple of an angle, then a step at full speed",
       readKingsMoves},
      {GoalRelativeActions::TYPE, "headings relative to the goal's bearing, limited by the separation rule",
       readGoalRelativeActions},
  };
  return TYPES;
}

std::shared_ptr<const ActionSet> makeActionSet(const YAML::Node& node, const YamlPlace& place) {
  return readPart(actionSetTypes(), node, place, "");
}

}  // namespace crowd
