#include "scenario/reading/list_reader.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

constexpr const char* ALL = "all";

/// Reads `all`, which is no area, or an area.
std::optional<Region> readAlarmArea(const YamlMap& map) {
  const YAML::Node node = map.need("area");
  if (node.IsScalar() && node.Scalar() == ALL) return std::nullopt;
  if (!node.IsMap()) throwExpected(map.placeOf("area"), node, "all, {box: ...} or {ring: ...}");
  return readArea(map);
}

}  // namespace

std::vector<AlarmDescription> readAlarms(const YamlMap& map, const std::vector<SinkDescription>& sinks) {
  const auto read = [&](const YAML::Node& node, const YamlPlace& place) {
    const YamlMap entry(node, place, {"time", "area", "sink", "speed_factor", "reaction_time", "keep_sources"});
    AlarmDescription alarm;
    alarm.line = lineOf(node);
    alarm.time = entry.number("time", NumberRule::NOT_NEGATIVE);
    alarm.area = readAlarmArea(entry);
    alarm.speed_factor = entry.number("speed_factor", limits::PACE, 1.0);
    if (entry.has("sink")) alarm.route = alarmRoute(readSinkName(entry, sinks));
    for (const char* key : {"reaction_time", "keep_sources"}) {
      if (entry.has(key) && !alarm.route) throwProblem(entry.placeOf(key), entry.need(key), "goes with a sink only");
    }
    if (const YAML::Node reaction = entry.find("reaction_time")) {
      alarm.reaction_time = readRange(reaction, entry.placeOf("reaction_time"), NumberRule::NOT_NEGATIVE);
    }
    alarm.keeps_sources = entry.flag("keep_sources", false);
    return alarm;
  };
  return readList<AlarmDescription>(map.find("alarms"), map.placeOf("alarms"), read);
}

}  // namespace crowd
