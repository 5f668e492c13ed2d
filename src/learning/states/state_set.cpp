#include "learning/states/state_set.h"

#include "learning/states/anticipation_states.h"
#include "learning/states/condensed_occupancy_states.h"
#include "learning/states/nearest_obstacle_states.h"
#include "learning/states/occupancy_states.h"

namespace crowd {

const std::vector<StateSetType>& stateSetTypes() {
  static const std::vector<StateSetType> TYPES = {
      {NearestObstacleStates::TYPE, "thesis set 1: goal sector; sector and distance class of the nearest obstacle",
       readNearestObstacleStates},
      {OccupancyStates::TYPE, "thesis set 2: goal sector; distance class of each sector", readOccupancyStates},
      {CondensedOccupancyStates::TYPE, "set 2 with one nearest distance for all sectors", readCondensedOccupancyStates},
      {AnticipationStates::TYPE, "one row per action: times to collision and admissible fraction of its move",
       readAnticipationStates},
  };
  return TYPES;
}

std::shared_ptr<const StateSet> makeStateSet(const YAML::Node& node, const YamlPlace& place,
                                             const ActionSet& action_set) {
  return readPart(stateSetTypes(), node, place, "", action_set);
}

}  // namespace crowd
