#include "social_crowd/learning/states/state_set.h"

#include "social_crowd/learning/states/anticipation_states.h"
#include "social_crowd/learning/states/condensed_occupancy_states.h"
#include "social_crowd/learning/states/nearest_obstacle_states.h"
#include "social_crowd/learning/states/occupancy_states.h"

namespace crowd {
namespace {

constexpr int MAX_GOAL_SECTORS = 64;

DistanceClasses readDistances(const YamlMap& map) {
  DistanceClasses distances;
  distances.collision_radius = map.number("collision_radius", NumberRule::POSITIVE, distances.collision_radius);
  distances.vision_radius = map.number("vision_radius", NumberRule::POSITIVE, distances.vision_radius);
  if (distances.vision_radius <= distances.collision_radius) {
    throwExpected(map.placeOf("vision_radius"), map.node(), "a radius of vision above the collision radius");
  }
  return distances;
}

std::vector<double> readSectorLimits(const YamlMap& map, const std::vector<double>& otherwise) {
  const YAML::Node node = map.find("obstacle_sectors");
  if (!node) return otherwise;
  const YamlPlace place = map.placeOf("obstacle_sectors");
  const char* const expected = "a list of rising limits [degrees], the last one 180, such as [15, 45, 90, 180]";
  if (!node.IsSequence() || node.size() == 0) throwExpected(place, node, expected);
  std::vector<double> limits;
  for (std::size_t i = 0; i < node.size(); ++i) {
    limits.push_back(readNumber(node[i], place.element(i), NumberRule::POSITIVE));
    if (i > 0 && limits[i] <= limits[i - 1]) throwExpected(place.element(i), node[i], expected);
  }
  if (limits.back() != 180.0) throwExpected(place, node, expected);
  return limits;
}

OccupancyStates::Parameters readOccupancy(YamlMap& map) {
  map.allow({"type", "sectors", "collision_radius", "vision_radius"});
  OccupancyStates::Parameters parameters;
  parameters.sectors = static_cast<int>(map.whole("sectors", 2, OccupancyStates::MAX_SECTORS, parameters.sectors));
  parameters.distances = readDistances(map);
  return parameters;
}

}  // namespace

std::shared_ptr<const StateSet> makeStateSet(const YAML::Node& node, const YamlPlace& place,
                                             const std::shared_ptr<const ActionSet>& action_set) {
  YamlMap map(node, place);
  const std::string type = map.text("type");
  if (type == NearestObstacleStates::TYPE) {
    map.allow({"type", "goal_sectors", "obstacle_sectors", "collision_radius", "vision_radius"});
    NearestObstacleStates::Parameters parameters;
    parameters.goal_sectors = static_cast<int>(map.whole("goal_sectors", 1, MAX_GOAL_SECTORS, parameters.goal_sectors));
    parameters.obstacle_sectors = readSectorLimits(map, parameters.obstacle_sectors);
    parameters.distances = readDistances(map);
    return std::make_shared<NearestObstacleStates>(parameters);
  }
  if (type == AnticipationStates::TYPE) return readAnticipationStates(map, action_set->size());
  if (type == OccupancyStates::TYPE) return std::make_shared<OccupancyStates>(readOccupancy(map));
  if (type == CondensedOccupancyStates::TYPE) return std::make_shared<CondensedOccupancyStates>(readOccupancy(map));
  throwExpected(map.placeOf("type"), map.need("type"),
                "nearest_obstacle, occupancy, condensed_occupancy or anticipation");
}

}  // namespace crowd
