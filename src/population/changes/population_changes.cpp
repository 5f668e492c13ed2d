#include "population/changes/population_changes.h"

#include <algorithm>
#include <utility>

#include "common/text/quotes.h"
#include "common/text/yaml_reader.h"
#include "scenario/population_checks.h"
#include "scenario/reading/population_reader.h"
#include "scenario/reading/units.h"
#include "scenario/writing/population_document.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

PopulationDescription populationOf(const Scene& scene) {
  return scene.population ? *scene.population : PopulationDescription();
}

/// Writes a population as in a scenario file and reads it, so that the checks are those of the reader.
void requireReadable(const PopulationDescription& population) {
  const YamlMap map(YAML::Load(populationText(population)), {},
                    {"routes", "sources", "sinks", "queues", "gates", "attractions", "alarms"});
  PopulationDescription read = readPopulation(map);
  read.kinds = population.kinds;
  readSources(map, Units(), read);
}

bool isOnRoute(const Scene& scene, std::size_t route) {
  const auto begins = [route](const auto& agents) { return agents.route == route; };
  const std::vector<SourceDescription> none;
  const auto& sources = scene.population ? scene.population->sources : none;
  return std::any_of(scene.agents.begin(), scene.agents.end(), begins) ||
         std::any_of(sources.begin(), sources.end(), [&](const auto& source) { return begins(source.agents); });
}

/// What agents of a new source may visit. Places where only others go are left out: walls of users may be there now.
PopulationDescription placesFor(const SourceDescription& source, const Scene& scene) {
  PopulationDescription places = populationOf(scene);
  places.sources = {source};
  for (std::size_t route = 0; route < places.routes.size(); ++route) {
    if (source.agents.route != route && isOnRoute(scene, route)) places.routes[route].waypoints.clear();
  }
  return places;
}

/// Calls check(). The error loses what stands before the field: file and line, which a user has not written.
template <typename Check>
void requireField(const std::string& field, const Check& check) {
  try {
    check();
  } catch (const InputError& error) {
    const std::string text = error.what();
    const std::size_t found = text.find(field + ".");
    throw InputError(found == std::string::npos ? text : text.substr(found + field.size() + 1));
  }
}

}  // namespace

PopulationDescription withSource(const Scene& scene, const SourceDescription& source,
                                 const std::vector<Segment>& walls) {
  PopulationDescription population = populationOf(scene);
  population.sources.push_back(source);
  requireField("sources[" + std::to_string(population.sources.size() - 1) + "]", [&] { requireReadable(population); });
  Scenario alone;
  alone.source = "the scenario";
  alone.walls = walls;
  alone.map = scene.map;
  for (const RobotStart& robot : scene.robots) alone.robots.emplace_back().start = robot;
  alone.population = std::make_shared<const PopulationDescription>(placesFor(source, scene));
  requireField("sources[0]", [&] { checkPopulation(alone); });
  return population;
}

PopulationDescription withAlarm(const Scene& scene, const AlarmDescription& alarm) {
  PopulationDescription population = populationOf(scene);
  population.alarms.push_back(alarm);
  requireField("alarms[" + std::to_string(population.alarms.size() - 1) + "]", [&] { requireReadable(population); });
  return population;
}

PopulationDescription withGate(const Scene& scene, const GateDescription& gate) {
  PopulationDescription population = populationOf(scene);
  if (gate.name.empty()) throw InputError("gate: expected a name, got an empty text");
  requireShort("gate", gate.name);
  if (findName(population.gates, gate.name))
    throw InputError("gate: there is a gate " + inQuotes(gate.name) + " already");
  population.gates.push_back(gate);
  requireField("gates." + gate.name, [&] { requireReadable(population); });
  return population;
}

}  // namespace crowd
