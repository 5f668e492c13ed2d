#include "common/text/numbers.h"
#include "scenario/reading/agent_reader.h"
#include "scenario/reading/group_reader.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

constexpr std::int64_t MAX_AGENTS = 1'000'000'000;

enum class Interval { EXPONENTIAL, REGULAR };
constexpr EnumNames<Interval, 2> INTERVALS{"interval", {"exponential", "regular"}};

std::vector<double> readTimes(const YAML::Node& node, const YamlPlace& place) {
  const auto read = [](const YAML::Node& time, const YamlPlace& at) {
    return readNumber(time, at, NumberRule::NOT_NEGATIVE);
  };
  std::vector<double> times = readList<double>(node, place, read);
  if (times.empty()) throwExpected(place, node, "at least one time");
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] >= times[i - 1]) continue;
    throwProblem(place.element(i), node[i],
                 "expected ascending times, got " + toText(times[i]) + " after " + toText(times[i - 1]));
  }
  return times;
}

void readRate(const YamlMap& map, SourceDescription& source) {
  source.rate = map.number("rate", limits::RATE);
  source.regular = INTERVALS.read(map, Interval::EXPONENTIAL) == Interval::REGULAR;
  source.from = map.number("from", NumberRule::NOT_NEGATIVE, 0.0);
  source.until = map.number("until", NumberRule::NOT_NEGATIVE, source.until);
  if (source.until > source.from) return;
  throwProblem(map.placeOf("until"), map.need("until"), "expected a time after `from`, " + toText(source.from) + " s");
}

void readSchedule(const YamlMap& map, SourceDescription& source) {
  const YAML::Node times = map.find("times");
  if (map.has("rate") == map.has("times")) {
    throwProblem(
        map.place(), map.node(),
        map.has("rate") ? "expected either rate or times, got both" : "expected either rate or times, got neither");
  }
  if (!times) {
    readRate(map, source);
  } else {
    source.times = readTimes(times, map.placeOf("times"));
    for (const char* key : {"interval", "from", "until"}) {
      if (map.has(key)) throwProblem(map.placeOf(key), map.need(key), "goes with rate only");
    }
  }
  if (map.has("count")) source.count = static_cast<std::uint64_t>(map.whole("count", 1, MAX_AGENTS));
}

}  // namespace

std::vector<SourceDescription> readSources(const YamlMap& map, const Units& units,
                                           const PopulationDescription& population) {
  const auto read = [&](const YAML::Node& node, const YamlPlace& place) {
    const YamlMap entry(node, place,
                        {"area", "rate", "times", "interval", "from", "until", "count", "goal", "goals", "route",
                         "kind", "speed", "hurry", "radius", "groups", "reaction"});
    SourceDescription source;
    source.agents.line = lineOf(node);
    source.agents.position = readRegion(entry.need("area"), entry.placeOf("area"));
    readSchedule(entry, source);
    readWalk(entry, units, population, source.agents);
    source.agents.groups = readGroupShare(entry);
    return source;
  };
  return readList<SourceDescription>(map.find("sources"), map.placeOf("sources"), read);
}

}  // namespace crowd
