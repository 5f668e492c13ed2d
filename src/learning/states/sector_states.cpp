#include "learning/states/sector_states.h"

#include "common/text/numbers.h"
#include "geometry/limits.h"

namespace crowd {

std::string SectorStates::distancesSpec() const {
  return ", collision_radius: " + toText(distances_.collision_radius) +
         ", vision_radius: " + toText(distances_.vision_radius);
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
