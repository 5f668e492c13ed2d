#pragma once

#include <vector>

#include "common/text/yaml_reader.h"

namespace crowd {

/// @brief Applies `read` to each element of a list; an absent or null list is empty.
template <typename T, typename Read>
std::vector<T> readList(const YAML::Node& node, const YamlPlace& place, Read read) {
  std::vector<T> list;
  if (!node || node.IsNull()) {
    return list;
  }
  if (!node.IsSequence()) {
    throwExpected(place, node, "a list");
  }
  list.reserve(node.size());
  for (const YAML::Node& element : node) {
    list.push_back(read(element, place.element(list.size())));
  }
  return list;
}

/// @brief The line of a node in its file, counted from 1.
inline int lineOf(const YAML::Node& node) { return node.Mark().line + 1; }

}  // namespace crowd
