#pragma once

#include <vector>

#include "learning/rl/rows.h"

namespace crowd {

/// @brief Maps rows and actions of a Q-table to their mirror images, with left and right exchanged.
class Mirror {
 public:
  /// @brief The identity: every row and action is its own mirror image.
  Mirror() = default;
  /// @brief Collects the mirror images that a state set and an action set define.
  template <typename StateSet, typename ActionSet>
  Mirror(const StateSet& state_set, const ActionSet& action_set)
      : rows_(state_set.rowCount()), actions_(action_set.size()) {
    for (Row row = 0; row < rows_.size(); ++row) rows_[row] = state_set.mirrored(row);
    for (Action action = 0; action < actions_.size(); ++action) actions_[action] = action_set.mirrored(action);
  }

  Row row(Row row) const { return rows_.empty() ? row : rows_[row]; }
  Action action(Action action) const { return actions_.empty() ? action : actions_[action]; }
  /// @brief Whether the mirror image of a pair of row and action is a different pair.
  bool hasImage(Row row, Action action) const {
    return !rows_.empty() && (rows_[row] != row || actions_[action] != action);
  }

 private:
  std::vector<Row> rows_;
  std::vector<Action> actions_;
};

}  // namespace crowd
