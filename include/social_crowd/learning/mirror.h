#pragma once

#include <vector>

#include "social_crowd/learning/action_set.h"
#include "social_crowd/learning/state_set.h"

namespace crowd {

/// @brief Left and right exchanged: which rows and actions of a Q-table are each other's mirror image.
class Mirror {
 public:
  /// @brief Everything is its own mirror image: nothing is mirrored.
  Mirror() = default;
  Mirror(const StateSet& state_set, const ActionSet& action_set);

  Row row(Row row) const { return rows_.empty() ? row : rows_[row]; }
  Action action(Action action) const { return actions_.empty() ? action : actions_[action]; }
  /// @brief Whether the mirror image of a row and action is another one.
  bool hasImage(Row row, Action action) const {
    return !rows_.empty() && (rows_[row] != row || actions_[action] != action);
  }

 private:
  std::vector<Row> rows_;
  std::vector<Action> actions_;
};

}  // namespace crowd
