#pragma once

#include <memory>
#include <string>

#include "social_crowd/learning/action_set.h"
#include "social_crowd/learning/reward.h"
#include "social_crowd/learning/state_set.h"

namespace crowd {

/// @brief What the numbers of a Q-table mean: state set, action set and the reward they were learned for. Cheap to
/// copy; the parts are immutable and shared.
struct Model {
  std::shared_ptr<const StateSet> state_set;
  std::shared_ptr<const ActionSet> action_set;
  std::shared_ptr<const Reward> reward;

  /// @brief How far an agent must perceive so that the state set sees all it looks at.
  Vision vision() const;
  /// @brief Whether a table of the other model can be used with this one: same state set, same action set.
  bool fits(const Model& other) const;
  /// @brief The three parts as YAML, each on a line of its own: `state_set: {...}` and so on.
  std::string spec() const;
};

/// @brief Refuses a table of another state set or action set. @param what stands for the table in the message.
/// @throws ShapeError
void requireFit(const Model& expected, const Model& got, const std::string& what);

/// @brief Reads the keys state_set, action_set and reward of a map.
/// @throws InputError if one is missing or wrong.
Model readModel(YamlMap& map);

/// @brief The model that Model::spec() describes. @throws InputError if the text is no such thing.
Model parseModel(const std::string& spec);

}  // namespace crowd
