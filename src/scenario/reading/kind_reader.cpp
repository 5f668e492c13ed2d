#include "scenario/reading/kind_reader.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "common/text/numbers.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/region_reader.h"
#include "scenario/reading/scenario_files.h"
#include "scenario/reading/share_reader.h"

namespace crowd {
namespace {

constexpr double SHORTEST_PAUSE = 0.01;  // [s]; a tick may have many pauses

Range readSpeedRange(const YAML::Node& node, const YamlPlace& place, const Units& units) {
  return units.speed(readRange(node, place, units.limit(limits::SPEED)));
}

Distribution readSpeed(const YAML::Node& node, const YamlPlace& place, const Units& units) {
  if (!node.IsMap()) return {readSpeedRange(node, place, units), std::nullopt};
  const YamlMap map(node, place, {"mean", "deviation", "range"});
  Distribution speed;
  speed.range = readSpeedRange(map.need("range"), map.placeOf("range"), units);
  speed.normal = {units.speed(map.number("mean", units.limit(limits::SPEED))),
                  units.speed(map.number("deviation", units.limit(limits::SPEED)))};
  if (speed.normal->mean < speed.range.low || speed.normal->mean > speed.range.high) {
    throwExpected(map.placeOf("mean"), map.need("mean"), "a mean within the range");
  }
  return speed;
}

PauseDescription readPauses(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"every", "duration", "speed"});
  PauseDescription pauses;
  pauses.every = map.number("every", NumberRule::POSITIVE);
  pauses.duration = readRange(map.need("duration"), map.placeOf("duration"), NumberRule::POSITIVE);
  if (pauses.duration.low < SHORTEST_PAUSE) {
    throwExpected(map.placeOf("duration"), map.need("duration"), "at least " + toText(SHORTEST_PAUSE) + " s");
  }
  pauses.speed = map.number("speed", NumberRule::FRACTION, 0.0);
  return pauses;
}

PersonKind readKind(const YAML::Node& node, const YamlPlace& place, const Units& units) {
  const YamlMap map(node, place, {"speed", "radius", "figure", "pauses"});
  PersonKind kind;
  kind.source = place.file + (place.document > 0 ? ": document " + std::to_string(place.document) : "");
  kind.speed = readSpeed(map.need("speed"), map.placeOf("speed"), units);
  kind.radius = readRange(map.need("radius"), map.placeOf("radius"), limits::RADIUS);
  kind.figure = FIGURES.read(map, Figure::ADULT);
  if (const YAML::Node pauses = map.find("pauses")) kind.pauses = readPauses(pauses, map.placeOf("pauses"));
  return kind;
}

std::vector<PersonKind> readKindMap(const YAML::Node& node, const YamlPlace& place, const Units& units) {
  return readNamed<PersonKind>(node, place,
                               [&](const YAML::Node& kind, const YamlPlace& at) { return readKind(kind, at, units); });
}

/// Speeds in files are in m/s.
std::vector<PersonKind> readKindFile(const std::string& file) {
  const std::vector<YAML::Node> documents = loadYamlStream(file);
  if (documents.size() != 1) throw InputError(file + ": expected one YAML document with kinds of people");
  return readKindMap(documents.front(), {file, 0, ""}, Units());
}

std::vector<PersonKind> readOwnKinds(const YamlMap& map, const Units& units) {
  const YAML::Node node = map.find("kinds");
  if (!node || !node.IsScalar()) return readKindMap(node, map.placeOf("kinds"), units);
  try {
    return readKindFile((std::filesystem::path(map.place().file).parent_path() / node.Scalar()).string());
  } catch (const Error& error) {
    throwProblem(map.placeOf("kinds"), node, error.what());
  }
}

bool hasKind(const YAML::Node& entries) {
  if (!entries || !entries.IsSequence()) return false;
  return std::any_of(entries.begin(), entries.end(),
                     [](const YAML::Node& entry) { return entry.IsMap() && entry["kind"]; });
}

KindShare readShare(const std::string& name, double share, const YAML::Node& node, const YamlPlace& place,
                    const std::vector<PersonKind>& kinds) {
  const auto found = findName(kinds, name);
  if (!found) throwProblem(place, node, unknownNameText("kind", name, namesOf(kinds)));
  return {*found, share};
}

void include(const Range& range, Range& all) { all = {std::min(all.low, range.low), std::max(all.high, range.high)}; }

}  // namespace

std::string shippedKindsFile() {
  return (std::filesystem::path(shippedScenarios()).parent_path() / "kinds.yaml").string();
}

std::vector<PersonKind> readKinds(const YamlMap& map, const Units& units) {
  std::vector<PersonKind> kinds = readOwnKinds(map, units);
  if (!hasKind(map.find("agents")) && !hasKind(map.find("sources"))) return {};
  for (PersonKind& kind : readKindFile(shippedKindsFile())) {
    if (!findName(kinds, kind.name)) kinds.push_back(std::move(kind));
  }
  return kinds;
}

void readKindsOf(const YamlMap& map, const std::vector<PersonKind>& kinds, AgentGroup& group) {
  readShares(map, "kind", [&](const std::string& name, double share, const YAML::Node& node, const YamlPlace& place) {
    group.kinds.push_back(readShare(name, share, node, place, kinds));
  });
  if (group.kinds.empty()) return;
  group.max_speed = kinds[group.kinds.front().kind].speed.range;
  group.radius = kinds[group.kinds.front().kind].radius;
  for (const KindShare& each : group.kinds) {
    include(kinds[each.kind].speed.range, group.max_speed);
    include(kinds[each.kind].radius, group.radius);
  }
}

void readReactions(const YamlMap& map, AgentGroup& group) {
  const std::vector<std::string> names(REACTIONS.names().begin(), REACTIONS.names().end());
  const auto add = [&](const std::string& name, double share, const YAML::Node& node, const YamlPlace& place) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throwProblem(place, node, unknownNameText("reaction", name, names));
    group.reactions.push_back({static_cast<Reaction>(std::distance(names.begin(), found)), share});
  };
  readShares(map, "reaction", add);
}

void keepUsedKinds(std::vector<AgentGroup>& agents, PopulationDescription& population) {
  std::set<std::size_t> used;
  const auto for_each_share = [&](const auto& work) {
    for (AgentGroup& group : agents) std::for_each(group.kinds.begin(), group.kinds.end(), work);
    for (SourceDescription& source : population.sources) {
      std::for_each(source.agents.kinds.begin(), source.agents.kinds.end(), work);
    }
  };
  for_each_share([&](const KindShare& each) { used.insert(each.kind); });
  std::vector<PersonKind> kept;
  kept.reserve(used.size());
  for (const std::size_t kind : used) kept.push_back(population.kinds[kind]);
  population.kinds = std::move(kept);
  for_each_share([&](KindShare& each) {
    each.kind = static_cast<std::size_t>(std::distance(used.begin(), used.find(each.kind)));
  });
}

}  // namespace crowd
