#pragma once

#include <string>
#include <vector>

#include "common/text/yaml_reader.h"
#include "scenario/scenario.h"

namespace crowd {

/// @brief Reads a number or [low, high]. @throws InputError, as all functions of this file do
Range readRange(const YAML::Node& node, const YamlPlace& place, const NumberLimit& limit);

/// @brief Reads [x, y], {box: ...}, {ring: ...} or {map: free}.
/// @param expected the permitted forms, for messages; callers that permit other forms handle these before
Region readRegion(const YAML::Node& node, const YamlPlace& place,
                  const std::string& expected = "[x, y], {box: ...}, {ring: ...} or {map: free}");

/// @brief Reads `area`, a region that is not {map: free}.
Region readArea(const YamlMap& map);

/// @brief Reads a list of one or more regions.
std::vector<Region> readRegions(const YAML::Node& node, const YamlPlace& place);

/// @brief Reads a wall [[x1, y1], [x2, y2]].
Segment readWall(const YAML::Node& node, const YamlPlace& place);

/// @brief Reads `count` of an entry of bodies. @param is_fixed whether the position of a body is not drawn
int readBodyCount(const YamlMap& map, bool is_fixed);

/// @brief Reads a heading: degrees as a number or [low, high], or {radians: ANGLE}. @return [rad]
Range readHeading(const YAML::Node& node, const YamlPlace& place);

/// @brief The value in {KEY: VALUE}; an undefined node (false) if the node is anything else.
YAML::Node findOnly(const std::string& key, const YAML::Node& node, const YamlPlace& place);

}  // namespace crowd
