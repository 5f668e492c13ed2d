#pragma once

#include <memory>
#include <string>
#include <vector>

#include "common/text/suggestions.h"
#include "common/text/yaml_reader.h"

namespace crowd {

/// @brief Registration of one type of a part of a model, such as the state set `occupancy`.
/// @tparam Part StateSet, ActionSet or Reward
/// @tparam Given what the reader needs beside the map
template <typename Part, typename... Given>
struct PartType {
  const char* name;     ///< value of the key `type`
  const char* summary;  ///< one line for docs/state_sets.md, with the keys, unless the page describes them
  /// Creates the part from its YAML map. It must call map.allow() with all keys, `type` included, and throws
  /// InputError.
  std::shared_ptr<const Part> (*read)(YamlMap& map, const Given&... given);
};

/// @brief Returns "a, b or c" for the names of the types.
template <typename Part, typename... Given>
std::string namesOf(const std::vector<PartType<Part, Given...>>& types) {
  std::vector<std::string> names;
  names.reserve(types.size());
  for (const auto& type : types) names.emplace_back(type.name);
  return joinAlternatives(names);
}

/// @brief Creates the part that a YAML map describes.
/// @param default_type type of a map without the key `type`; empty: the key is required
/// @throws InputError if the type is unknown or a parameter is invalid
template <typename Part, typename... Given>
std::shared_ptr<const Part> readPart(const std::vector<PartType<Part, Given...>>& types, const YAML::Node& node,
                                     const YamlPlace& place, const std::string& default_type, const Given&... given) {
  YamlMap map(node, place);
  const std::string name = default_type.empty() ? map.text("type") : map.text("type", default_type);
  for (const auto& type : types) {
    if (type.name == name) return type.read(map, given...);
  }
  throwExpected(map.placeOf("type"), map.need("type"), namesOf(types));
}

}  // namespace crowd
