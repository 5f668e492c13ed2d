#include "learning/model.h"

#include "common/text/quotes.h"
#include "geometry/limits.h"

namespace crowd {
namespace {

bool readOcclusion(const YamlMap& map) {
  const YAML::Node node = map.find("vision");
  if (!node) return false;
  return YamlMap(node, map.placeOf("vision"), {"occlusion"}).flag("occlusion", false);
}

void requireSmallTable(const YamlMap& map, const Model& model) {
  const std::uint64_t rows = model.state_set->rowCount();
  const std::uint64_t actions = model.action_set->size();
  if (rows * actions <= limits::Q_VALUES) return;
  throwProblem(map.placeOf("state_set"), map.need("state_set"),
               "expected a Q-table of at most " + std::to_string(limits::Q_VALUES) + " values, got " +
                   std::to_string(rows) + " rows of " + std::to_string(actions));
}

}  // namespace

Vision Model::vision() const {
  Vision vision;
  // Rounding in the perception must not drop bodies exactly at the limit of the state set.
  constexpr double MARGIN = 1e-6;  // [m]
  vision.radius = state_set->visionRadius() + MARGIN;
  vision.occlusion = occlusion;
  vision.max_neighbours = state_set->maxNeighbours();
  if (!occlusion) vision.wall_distance = state_set->wallDistance();  // walls farther away hide others, too
  vision.motion = action_set->motion();
  return vision;
}

bool Model::fits(const Model& other) const {
  return state_set->spec() == other.state_set->spec() && action_set->spec() == other.action_set->spec();
}

std::string Model::spec() const {
  return "state_set: " + state_set->spec() + "\naction_set: " + action_set->spec() + "\nreward: " + reward->spec() +
         "\n" + (occlusion ? "vision: {occlusion: true}\n" : "");
}

void requireFit(const Model& expected, const Model& got, const std::string& what) {
  if (expected.fits(got)) return;
  const std::string problem = what + ": was learned for another state set or action set";
  if (HiddenQuotes::areActive()) throw ShapeError(problem + " than\n" + expected.spec());
  throw ShapeError(problem + "\n" + got.spec() + "and not for\n" + expected.spec());
}

Model readModel(const YamlMap& map) {
  Model model;
  model.action_set = makeActionSet(map.need("action_set"), map.placeOf("action_set"));
  model.state_set = makeStateSet(map.need("state_set"), map.placeOf("state_set"), *model.action_set);
  requireSmallTable(map, model);
  model.reward = makeReward(map.need("reward"), map.placeOf("reward"), *model.state_set);
  model.occlusion = readOcclusion(map);
  return model;
}

Model parseModel(const std::string& spec) {
  const YamlPlace place{"model", 0, ""};
  const std::vector<YAML::Node> documents = parseYamlStream(spec, place.file);
  if (documents.size() != 1) throw InputError("model: expected one YAML document");
  return readModel(YamlMap(documents.front(), place, {"state_set", "action_set", "reward", "vision"}));
}

}  // namespace crowd
