#include "learning/states/state_set.h"

namespace crowd {

// Each is in the file of its name.
StateSetType nearestObstacleStates();
StateSetType occupancyStates();
StateSetType condensedOccupancyStates();
StateSetType anticipationStates();

const std::vector<StateSetType>& stateSetTypes() {
  static const std::vector<StateSetType> TYPES = {
      nearestObstacleStates(),
      occupancyStates(),
      condensedOccupancyStates(),
      anticipationStates(),
  };
  return TYPES;
}

std::shared_ptr<const StateSet> makeStateSet(const YAML::Node& node, const YamlPlace& place,
                                             const ActionSet& action_set) {
  return readPart(stateSetTypes(), node, place, "", action_set);
}

}  // namespace crowd
