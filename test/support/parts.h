#pragma once

#include <memory>
#include <string>

#include "learning/rewards/reward.h"

namespace crowd {

/// @brief The action set of a YAML map, as in a configuration.
inline std::shared_ptr<const ActionSet> actionsOf(const std::string& yaml) {
  return makeActionSet(YAML::Load(yaml), {"file.yaml", 0, "action_set"});
}

/// @brief The state set of a YAML map.
inline std::shared_ptr<const StateSet> statesOf(const std::string& yaml, const ActionSet& actions) {
  return makeStateSet(YAML::Load(yaml), {"file.yaml", 0, "state_set"}, actions);
}

/// @brief The same, for king's moves.
inline std::shared_ptr<const StateSet> statesOf(const std::string& yaml) {
  return statesOf(yaml, *actionsOf("{type: kings_moves}"));
}

/// @brief The reward of a YAML map.
inline std::shared_ptr<const Reward> rewardOf(const std::string& yaml, const StateSet& states) {
  return makeReward(YAML::Load(yaml), {"file.yaml", 0, "reward"}, states);
}

}  // namespace crowd
