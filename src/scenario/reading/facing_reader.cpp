#include "scenario/reading/facing_reader.h"

#include "geometry/limits.h"
#include "scenario/reading/region_reader.h"

namespace crowd {

std::optional<FacingDescription> readFacing(const YamlMap& map) {
  using Kind = FacingDescription::Kind;
  const YAML::Node node = map.find("face");
  if (!node) return std::nullopt;
  const YamlPlace place = map.placeOf("face");
  FacingDescription face;
  if (const YAML::Node robot = findOnly("robot", node, place)) {
    face.kind = Kind::ROBOT;
    face.robot = readText(robot, place.child("robot"));
  } else if (node.IsSequence()) {
    face.kind = Kind::POINT;
    face.point = readVector(node, place, limits::PLACE);
  } else if (node.IsScalar()) {
    face.direction = readNumber(node, place);
  } else {
    throwExpected(place, node, "degrees, [x, y] or {robot: NAME}");
  }
  return face;
}

}  // namespace crowd
