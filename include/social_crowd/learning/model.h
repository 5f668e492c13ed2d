#pragma once

#include <memory>
#include <string>

#include "social_crowd/learning/actions/action_set.h"
#include "social_crowd/learning/rewards/reward.h"
#include "social_crowd/learning/states/state_set.h"

namespace crowd {

/// @brief What the numbers of a Q-table mean: state set, action set, the reward they were learned for, and what was
/// perceived then. Cheap to copy; the parts are immutable and shared.
struct Model {
  std::shared_ptr<const StateSet> state_set;
  std::shared_ptr<const ActionSet> action_set;
  std::shared_ptr<const Reward> reward;
  bool occlusion = false;  ///< what nearer neighbours and walls hide is not perceived

  /// @brief How an agent perceives, and how far it must so that the state set sees all it looks at.
  Vision vision() const;
  /// @brief Whether a table of the other model can be used with this one: same state set, same action set.
  bool fits(const Model& other) const;
  /// @brief The parts as YAML, each on a line of its own: `state_set: {...}` and so on; `vision` only where it is not
  /// the default.
  std::string spec() const;
};

/// @brief Refuses a table of another state set or action set. @param what stands for the table in the message.
/// @throws ShapeError
void requireFit(const Model& expected, const Model& got, const std::string& what);

/// @brief Reads the keys state_set, action_set, reward and, where it is there, vision of a map.
/// @throws InputError if one of the first three is missing, or any is wrong.
Model readModel(const YamlMap& map);

/// @brief The model that Model::spec() describes. @throws InputError if the text is no such thing.
Model parseModel(const std::string& spec);

}  // namespace crowd
