#include "learning/actions/action_set.h"

namespace crowd {

// Each is in the file of its name.
ActionSetType kingsMoves();
ActionSetType goalRelativeActions();

const std::vector<ActionSetType>& actionSetTypes() {
  static const std::vector<ActionSetType> TYPES = {
      kingsMoves(),
      goalRelativeActions(),
  };
  return TYPES;
}

std::shared_ptr<const ActionSet> makeActionSet(const YAML::Node& node, const YamlPlace& place) {
  return readPart(actionSetTypes(), node, place, "");
}

}  // namespace crowd
