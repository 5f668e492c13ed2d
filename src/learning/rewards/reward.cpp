#include "learning/rewards/reward.h"

namespace crowd {

// Each is in the file of its name.
RewardType thesisReward();
RewardType progressReward();

double distanceGained(const AgentPerception& before, const AgentPerception& after) {
  return before.goal_number == after.goal_number ? before.goal.norm() - after.goal.norm() : 0.0;
}

const std::vector<RewardType>& rewardTypes() {
  static const std::vector<RewardType> TYPES = {
      thesisReward(),
      progressReward(),
  };
  return TYPES;
}

std::shared_ptr<const Reward> makeReward(const YAML::Node& node, const YamlPlace& place, const StateSet& state_set) {
  return readPart(rewardTypes(), node, place, thesisReward().name, state_set);
}

}  // namespace crowd
