#include "social_crowd/learning/rewards/reward.h"

#include "social_crowd/learning/rewards/progress_reward.h"
#include "social_crowd/learning/rewards/thesis_reward.h"

namespace crowd {

double distanceGained(const AgentPerception& before, const AgentPerception& after) {
  return before.goal_number == after.goal_number ? before.goal.norm() - after.goal.norm() : 0.0;
}

std::shared_ptr<const Reward> makeReward(const YAML::Node& node, const YamlPlace& place, const StateSet& state_set) {
  YamlMap map(node, place);
  const std::string type = map.text("type", ThesisReward::TYPE);
  if (type == ThesisReward::TYPE) return readThesisReward(map, state_set);
  if (type == ProgressReward::TYPE) return readProgressReward(map);
  throwExpected(map.placeOf("type"), map.need("type"), "thesis or progress");
}

}  // namespace crowd
