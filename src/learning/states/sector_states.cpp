#include "learning/states/sector_states.h"

#include "common/text/numbers.h"
#include "geometry/limits.h"

namespace crowd {

std::string SectorStates::distancesSpec() const {
  return ", collision_radius: " + toText(distances_.collision_radius) +
         ", vision_radius: " + toText(distances_.vision_radius);
}

std::string sectorLimitsSpec(const std::vector<double>& degrees) {
  std::string limits;
  for (const double limit : degrees) limits += (limits.empty() ? "" : ", ") + toText(limit);
  return "obstacle_sectors: [" + limits + "]";
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

DistanceClasses readDistanceClasses(const YamlMap& map) {
  DistanceClasses distances;
  distances.collision_radius = map.number("collision_radius", limits::DISTANCE, distances.collision_radius);
  distances.vision_radius = map.number("vision_radius", limits::DISTANCE, distances.vision_radius);
  if (distances.vision_radius <= distances.collision_radius) {
    throwExpected(map.placeOf("vision_radius"), map.node(), "a radius of vision above the collision radius");
  }
  return distances;
}

}  // namespace crowd
