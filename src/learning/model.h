#pragma once

#include <memory>
#include <string>

#include "learning/actions/action_set.h"
#include "learning/rewards/reward.h"
#include "learning/states/state_set.h"

namespace crowd {

/// @brief Defines the meaning of a Q-table: state set, action set, the reward that it was learned for, and the kind of
/// perception. Cheap to copy; the parts are immutable and shared.
struct Model {
  std::shared_ptr<const StateSet> state_set;
  std::shared_ptr<const ActionSet> action_set;
  std::shared_ptr<const Reward> reward;
  bool occlusion = false;  ///< whether bodies hidden by nearer neighbours and walls are not perceived

  /// @brief Returns the vision that the model needs. The radius is slightly larger than that of the state set, so that
  /// the state set itself decides about bodies exactly at its limit.
  Vision vision() const;
  /// @brief Whether a table of the other model can be used with this one: the state sets and the action sets are equal.
  bool fits(const Model& other) const;
  /// @brief Returns the parts as YAML, one per line: `state_set: {...}` and so on; `vision` only if it is not the
  /// default.
  std::string spec() const;
};

/// @brief Requires that both models fit.
/// @param what name of the table in the message
/// @throws ShapeError if they do not fit
void requireFit(const Model& expected, const Model& got, const std::string& what);

/// @brief Reads the keys state_set, action_set, reward and, optionally, vision of a map.
/// @throws InputError if a required key is missing or a value is invalid
Model readModel(const YamlMap& map);

/// @brief Inverse of Model::spec(). @throws InputError if the text is invalid
Model parseModel(const std::string& spec);

}  // namespace crowd
