#pragma once

#include <string>

#include "common/text/yaml_reader.h"

namespace crowd {

/// @brief Reads a key of an entry: a name, or a map of names and their shares. Does nothing without the key.
/// @param add takes name, share, node and place of each name @throws InputError
template <typename Add>
void readShares(const YamlMap& map, const std::string& key, const Add& add) {
  constexpr NumberLimit SHARE{NumberRule::POSITIVE, 1e9, ""};
  const YAML::Node node = map.find(key);
  if (!node) return;
  const YamlPlace place = map.placeOf(key);
  if (node.IsMap() && node.size() > 0) {
    const YamlMap checked(node, place);
    for (const auto& entry : node) {
      const std::string& name = entry.first.Scalar();
      add(name, readNumber(entry.second, place.child(namePart(name)), SHARE), entry.first, place);
    }
  } else if (node.IsScalar()) {
    add(node.Scalar(), 1.0, node, place);
  } else {
    throwExpected(place, node, "the name of a " + key + ", or names and their shares {NAME: SHARE}");
  }
}

}  // namespace crowd
