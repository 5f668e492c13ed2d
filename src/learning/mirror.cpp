#include "social_crowd/learning/mirror.h"

namespace crowd {

Mirror::Mirror(const StateSet& state_set, const ActionSet& action_set)
    : rows_(state_set.rowCount()), actions_(action_set.size()) {
  for (Row row = 0; row < state_set.rowCount(); ++row) rows_[row] = state_set.mirrored(row);
  for (Action action = 0; action < action_set.size(); ++action) actions_[action] = action_set.mirrored(action);
}

}  // namespace crowd
