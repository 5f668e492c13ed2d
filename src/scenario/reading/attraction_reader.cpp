#include "scenario/reading/facing_reader.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

AttractionDescription readAttraction(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"area", "radius", "share", "wait", "face"});
  AttractionDescription attraction;
  attraction.area = readArea(map);
  attraction.radius = map.number("radius", limits::DISTANCE);
  attraction.share = map.number("share", NumberRule::FRACTION);
  attraction.wait = readRange(map.need("wait"), map.placeOf("wait"), NumberRule::NOT_NEGATIVE);
  attraction.face = readFacing(map);
  return attraction;
}

}  // namespace

std::vector<AttractionDescription> readAttractions(const YamlMap& map) {
  return readNamed<AttractionDescription>(map.find("attractions"), map.placeOf("attractions"), readAttraction);
}

}  // namespace crowd
