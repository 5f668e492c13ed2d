#include "learning/rewards/reward.h"

#include "learning/rewards/progress_reward.h"
#include "learning/rewards/thesis_reward.h"

namespace crowd {

double distanceGained(const AgentPerception& before, const AgentPerception& after) {
  return before.goal_number == after.goal_number ? before.goal.norm() - after.goal.norm() : 0.0;
}

const std::vector<RewardType>& rewardTypes() {
  static const std::vector<RewardType> TYPES = {
      {ThesisReward::TYPE, "the thesis's: arrival, approach of the goal, obstacles by distance class",
       readThesisReward},
      {ProgressReward::TYPE, "progress in ticks, less penalties on turning, collision courses, standing and contact",
       readProgressReward},
  };
  return TYPES;
}

std::shared_ptr<const Reward> makeReward(const YAML::Node& node, const YamlPlace& place, const StateSet& state_set) {
  return readPart(rewardTypes(), node, place, ThesisReward::TYPE, state_set);
}

}  // namespace crowd
