#include "scenario/reading/population_reader.h"

#include "scenario/reading/facing_reader.h"
#include "scenario/reading/list_reader.h"
#include "scenario/reading/region_reader.h"

namespace crowd {
namespace {

SinkDescription readSink(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"area"});
  SinkDescription sink;
  sink.area = readArea(map);
  return sink;
}

QueueDescription readQueue(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"head", "direction", "spacing", "service", "face"});
  QueueDescription queue;
  queue.head = readVector(map.need("head"), map.placeOf("head"), limits::PLACE);
  queue.direction = map.number("direction", NumberRule::ANY);
  queue.spacing = map.number("spacing", limits::DISTANCE);
  queue.service = readRange(map.need("service"), map.placeOf("service"), NumberRule::NOT_NEGATIVE);
  queue.face = readFacing(map);
  return queue;
}

Period readPeriod(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() != 2) throwExpected(place, node, "a period [begin, end]");
  const Period period{readNumber(node[0], place.element(0), NumberRule::NOT_NEGATIVE),
                      readNumber(node[1], place.element(1), NumberRule::NOT_NEGATIVE)};
  if (period.begin >= period.end) throwProblem(place, node, "expected [begin, end] with the earlier time first");
  return period;
}

std::vector<Period> readPeriods(const YAML::Node& node, const YamlPlace& place) {
  std::vector<Period> periods = readList<Period>(node, place, readPeriod);
  for (std::size_t i = 1; i < periods.size(); ++i) {
    if (periods[i].begin >= periods[i - 1].end) continue;
    throwProblem(place.element(i), node[i], "expected ascending periods, got one that begins before the last one ends");
  }
  return periods;
}

GateDescription readGate(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"wall", "open"});
  GateDescription gate;
  gate.wall = readWall(map.need("wall"), map.placeOf("wall"));
  const YAML::Node open = map.need("open");
  if (open.IsSequence()) {
    gate.open_in = readPeriods(open, map.placeOf("open"));
  } else if (open.IsScalar() && (open.Scalar() == "true" || open.Scalar() == "false")) {
    gate.open = map.flag("open", false);
  } else {
    throwExpected(map.placeOf("open"), open, "true, false, or a list of periods [[begin, end], ...]");
  }
  return gate;
}

}  // namespace

PopulationDescription readPopulation(const YamlMap& map) {
  PopulationDescription population;
  population.sinks = readNamed<SinkDescription>(map.find("sinks"), map.placeOf("sinks"), readSink);
  population.queues = readNamed<QueueDescription>(map.find("queues"), map.placeOf("queues"), readQueue);
  population.gates = readNamed<GateDescription>(map.find("gates"), map.placeOf("gates"), readGate);
  population.attractions = readAttractions(map);
  population.routes = readRoutes(map, population);
  population.alarms = readAlarms(map, population.sinks);
  return population;
}

WaypointDescription readSinkName(const YamlMap& map, const std::vector<SinkDescription>& sinks) {
  const std::string name = map.text("sink");
  try {
    return sinkWaypoint(name, sinks);
  } catch (const InputError& error) {
    throwProblem(map.placeOf("sink"), map.need("sink"), error.what());
  }
}

}  // namespace crowd
