#pragma once

#include "common/text/quotes.h"
#include "common/text/yaml_reader.h"
#include "scenario/population_spec.h"
#include "scenario/reading/units.h"

namespace crowd {

/// @brief Reads `sinks`, `queues`, `gates`, `attractions`, `routes` and `alarms` of a scenario document, which must
/// have declared these keys.
/// @throws InputError with file, document, line and field, as all functions of this file do
PopulationDescription readPopulation(const YamlMap& map);

/// @brief Reads `sources`. @param population its routes and kinds are known by name
std::vector<SourceDescription> readSources(const YamlMap& map, const Units& units,
                                           const PopulationDescription& population);

/// @brief Reads `routes`. @param population its sinks and queues are known by name
std::vector<RouteDescription> readRoutes(const YamlMap& map, const PopulationDescription& population);

/// @brief Reads `attractions`.
std::vector<AttractionDescription> readAttractions(const YamlMap& map);

/// @brief Reads `alarms`. @param sinks are known by name
std::vector<AlarmDescription> readAlarms(const YamlMap& map, const std::vector<SinkDescription>& sinks);

/// @brief Reads `sink`, the name of one or the nearest one, as a waypoint.
WaypointDescription readSinkName(const YamlMap& map, const std::vector<SinkDescription>& sinks);

/// @brief Reads the name of one of the descriptions, such as that of a route. @param key also names the kind in
/// messages
/// @return index of the description
template <typename Descriptions>
std::size_t readNameOf(const Descriptions& descriptions, const YamlMap& map, const std::string& key) {
  const std::string name = map.text(key);
  const auto found = findName(descriptions, name);
  if (!found) throwProblem(map.placeOf(key), map.need(key), unknownNameText(key, name, namesOf(descriptions)));
  return *found;
}

/// @brief A name that the user chose, as a part of the path in messages.
inline std::string namePart(const std::string& name) { return HiddenQuotes::areActive() ? "..." : shortened(name); }

/// @brief Applies `read(value, place)` to each entry of a map of names; an absent or null map is empty.
template <typename T, typename Read>
std::vector<T> readNamed(const YAML::Node& node, const YamlPlace& place, Read read) {
  std::vector<T> list;
  if (!node || node.IsNull()) return list;
  const YamlMap checked(node, place);
  for (const auto& entry : node) {
    const std::string& name = entry.first.Scalar();
    if (name.empty()) throwExpected(place, entry.first, "a name");
    list.push_back(read(entry.second, place.child(namePart(name))));
    list.back().name = name;
    list.back().line = entry.first.Mark().line + 1;
  }
  return list;
}

}  // namespace crowd
