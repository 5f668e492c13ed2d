#include "social_crowd/learning/actions/action_set.h"

#include "social_crowd/learning/actions/goal_relative_actions.h"
#include "social_crowd/learning/actions/kings_moves.h"

namespace crowd {

namespace {

std::shared_ptr<const ActionSet> readGoalRelativeActions(YamlMap& map) {
  map.allow({"type", "headings", "slow_headings", "slow_fraction", "stay", "gap_sharing", "lookout"});
  GoalRelativeActions::Parameters parameters;
  parameters.headings = map.risingNumbers("headings", 0.0, 180.0, parameters.headings);
  if (parameters.headings.empty()) throwExpected(map.placeOf("headings"), map.need("headings"), "at least one");
  parameters.slow_headings = map.risingNumbers("slow_headings", 0.0, 180.0, parameters.slow_headings);
  parameters.slow_fraction = map.number("slow_fraction", NumberRule::FRACTION, parameters.slow_fraction);
  parameters.stay = map.flag("stay", parameters.stay);
  const std::string sharing = map.text("gap_sharing", toText(parameters.gap_sharing));
  try {
    parameters.gap_sharing = parseGapSharing(sharing);
  } catch (const InputError&) {
    throwExpected(map.placeOf("gap_sharing"), map.need("gap_sharing"), "none, half or moving");
  }
  parameters.lookout = map.number("lookout", NumberRule::NOT_NEGATIVE, parameters.lookout);
  return std::make_shared<GoalRelativeActions>(parameters);
}

std::shared_ptr<const ActionSet> readKingsMoves(YamlMap& map) {
  map.allow({"type", "rotations", "stay"});
  const auto rotations = static_cast<int>(map.whole("rotations", 2, 360, KingsMoves::DEFAULT_ROTATIONS));
  const bool stay = map.flag("stay", false);
  return std::make_shared<KingsMoves>(rotations, stay);
}

}  // namespace

void ActionSet::findMoves(const DecisionContext& context) const {
  for (Action action = 0; action < size(); ++action) {
    const RelativeAction move = relativeAction(context.seen, action);
    setMove(context.moves, action, {unitVector(move.rotation), move.speed_fraction, move.speed_fraction});
  }
  repeatLast(context.moves, size());
}

std::shared_ptr<const ActionSet> makeActionSet(const YAML::Node& node, const YamlPlace& place) {
  YamlMap map(node, place);
  const std::string type = map.text("type");
  if (type == KingsMoves::TYPE) return readKingsMoves(map);
  if (type == GoalRelativeActions::TYPE) return readGoalRelativeActions(map);
  throwExpected(map.placeOf("type"), map.need("type"), "kings_moves or goal_relative");
}

}  // namespace crowd
