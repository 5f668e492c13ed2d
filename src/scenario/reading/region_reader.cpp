#include "scenario/reading/region_reader.h"

#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "common/text/suggestions.h"
#include "geometry/limits.h"

namespace crowd {

Range readRange(const YAML::Node& node, const YamlPlace& place, const NumberLimit& limit) {
  if (!node.IsSequence()) {
    const double value = readNumber(node, place, limit);
    return {value, value};
  }
  if (node.size() != 2) {
    throwExpected(place, node, "a number or [low, high]");
  }
  const Range range{readNumber(node[0], place.element(0), limit), readNumber(node[1], place.element(1), limit)};
  if (range.low > range.high) {
    throwProblem(place, node, "expected [low, high], got the higher number first");
  }
  return range;
}

namespace {

Region readBox(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() != 2) {
    throwExpected(place, node, "two corners [[x0, y0], [x1, y1]]");
  }
  Region region;
  region.kind = Region::Kind::BOX;
  region.first = readVector(node[0], place.element(0), limits::PLACE);
  region.second = readVector(node[1], place.element(1), limits::PLACE);
  if ((region.first.array() > region.second.array()).any()) {
    throwProblem(place, node, "expected the lower left corner, then the upper right one");
  }
  return region;
}

Region readRing(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"centre", "radius"});
  Region region;
  region.kind = Region::Kind::RING;
  region.first = readVector(map.need("centre"), map.placeOf("centre"), limits::PLACE);
  region.radius = readRange(map.need("radius"), map.placeOf("radius"), limits::DISTANCE_OR_0);
  if (region.radius.high <= 0.0) {
    throwProblem(map.placeOf("radius"), map.need("radius"), "expected an outer radius above 0");
  }
  const double extent = region.first.cwiseAbs().maxCoeff() + region.radius.high;
  if (extent > limits::PLACE.most) {
    throwProblem(
        place, node,
        "expected a ring with coordinates of up to " + toText(limits::PLACE.most) + " m, got " + toText(extent) + " m");
  }
  return region;
}

Region readFree(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsScalar() || node.Scalar() != "free") throwExpected(place, node, "free");
  Region region;
  region.kind = Region::Kind::FREE;
  return region;
}

/// Throws for a map of one key that is none of the keys that `expected` lists as {KEY: ...}.
[[noreturn]] void throwUnknownPlace(const YAML::Node& node, const YamlPlace& place, const std::string& expected) {
  std::vector<std::string> known;
  for (const char* key : {"box", "ring", "map", "opposite", "between"}) {
    if (expected.find(std::string("{") + key) != std::string::npos) known.emplace_back(key);
  }
  const std::string key = node.begin()->first.Scalar();
  throwProblem(place, node, "expected " + expected + ", got " + inQuotes(key) + didYouMean(key, known));
}

}  // namespace

Region readRegion(const YAML::Node& node, const YamlPlace& place, const std::string& expected) {
  if (node.IsSequence()) {
    Region region;
    region.first = readVector(node, place, limits::PLACE);
    return region;
  }
  if (const YAML::Node box = findOnly("box", node, place)) return readBox(box, place.child("box"));
  if (const YAML::Node ring = findOnly("ring", node, place)) return readRing(ring, place.child("ring"));
  if (const YAML::Node map = findOnly("map", node, place)) return readFree(map, place.child("map"));
  if (!node.IsMap() || node.size() != 1) throwExpected(place, node, expected);
  throwUnknownPlace(node, place, expected);
}

YAML::Node findOnly(const std::string& key, const YAML::Node& node, const YamlPlace& place) {
  const bool has_one = node.IsMap() && node.size() == 1;
  return has_one ? YamlMap(node, place).find(key) : YAML::Node(YAML::NodeType::Undefined);
}

Region readArea(const YamlMap& map) {
  const std::string expected = "[x, y], {box: ...} or {ring: ...}";
  const YAML::Node node = map.need("area");
  Region area = readRegion(node, map.placeOf("area"), expected);
  if (area.kind == Region::Kind::FREE) throwExpected(map.placeOf("area"), node, expected);
  return area;
}

std::vector<Region> readRegions(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() == 0) {
    throwExpected(place, node, "a list of one or more points");
  }
  std::vector<Region> regions;
  for (const YAML::Node& element : node) {
    regions.push_back(readRegion(element, place.element(regions.size())));
  }
  return regions;
}

Segment readWall(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() != 2) {
    throwExpected(place, node, "two ends [[x1, y1], [x2, y2]]");
  }
  Segment wall{readVector(node[0], place.element(0), limits::PLACE),
               readVector(node[1], place.element(1), limits::PLACE)};
  if (wall.from == wall.to) {
    throwProblem(place, node, "expected a wall with a length, got twice the same end");
  }
  return wall;
}

Range readHeading(const YAML::Node& node, const YamlPlace& place) {
  if (const YAML::Node radians = findOnly("radians", node, place)) {
    const double angle = readNumber(radians, place.child("radians"));
    return {angle, angle};
  }
  const Range degrees = readRange(node, place, NumberRule::ANY);
  return {toRadians(degrees.low), toRadians(degrees.high)};
}

int readBodyCount(const YamlMap& map, bool is_fixed) {
  const auto count = static_cast<int>(map.whole("count", 1, limits::COUNT, 1));
  if (count > 1 && is_fixed) {
    throwProblem(map.placeOf("count"), map.need("count"), "more than one body needs a region as position");
  }
  return count;
}

}  // namespace crowd
