#include "social_crowd/simulation/recipe.h"

#include <filesystem>

namespace crowd {
namespace {

std::vector<std::string> readFileNames(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() == 0) throwExpected(place, node, "a list of scenario files");
  const std::filesystem::path folder = std::filesystem::path(place.file).parent_path();
  std::vector<std::string> files;
  for (std::size_t i = 0; i < node.size(); ++i) {
    files.push_back((folder / readText(node[i], place.element(i))).lexically_normal().string());
  }
  return files;
}

TableUse readTableUse(YamlMap& map, TableUse otherwise) {
  try {
    return parseTableUse(map.text("tables", toText(otherwise)));
  } catch (const InputError&) {
    throwExpected(map.placeOf("tables"), map.need("tables"), "shared or own");
  }
}

TrainingPlan readTrainingPlan(const YAML::Node& node, const YamlPlace& place) {
  YamlMap map(node, place);
  TrainingPlan plan;
  plan.scenarios = readFileNames(map.need("scenarios"), map.placeOf("scenarios"));
  plan.episodes = static_cast<std::uint64_t>(map.whole("episodes", 1, INT64_MAX));
  plan.seed = map.count("seed", plan.seed);
  plan.tables = readTableUse(map, plan.tables);
  plan.save_every = static_cast<std::uint64_t>(map.whole("save_every", 0, INT64_MAX, 0));
  plan.side_by_side = static_cast<std::uint32_t>(map.whole("side_by_side", 1, 1024, plan.side_by_side));
  plan.turn = static_cast<std::uint32_t>(map.whole("turn", 1, INT32_MAX, plan.turn));
  map.finish();
  return plan;
}

}  // namespace

Recipe readRecipe(const std::string& file) {
  const std::vector<YAML::Node> documents = loadYamlStream(file);
  if (documents.size() != 1) {
    throw InputError(file + ": expected one YAML document, got " + std::to_string(documents.size()));
  }
  YamlMap map(documents.front(), {file, 0, ""});
  Recipe recipe;
  recipe.model = readModel(map);
  recipe.learning = readLearningPlan(map.need("learning"), map.placeOf("learning"));
  recipe.training = readTrainingPlan(map.need("training"), map.placeOf("training"));
  map.finish();
  return recipe;
}

}  // namespace crowd
