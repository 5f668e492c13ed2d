#include "training/training_config.h"

#include <filesystem>

#include "scenario/reading/scenario_files.h"

namespace crowd {
namespace {

std::vector<std::string> findScenarios(const YAML::Node& node, const YamlPlace& place) {
  if (!node.IsSequence() || node.size() == 0) throwExpected(place, node, "a list of scenario files");
  const std::filesystem::path folder = std::filesystem::path(place.file).parent_path();
  std::vector<std::string> files;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const YamlPlace at = place.element(i);
    const std::string name = readText(node[i], at);
    try {
      files.push_back(findScenario(name, folder));
    } catch (const InputError& error) {
      throwProblem(at, node[i], error.what());
    }
  }
  return files;
}

TrainingPlan readTrainingPlan(const YAML::Node& node, const YamlPlace& place) {
  const YamlMap map(node, place, {"scenarios", "episodes", "seed", "tables", "save_every", "side_by_side", "turn"});
  TrainingPlan plan;
  plan.episodes = static_cast<std::uint64_t>(map.whole("episodes", 1, INT64_MAX));
  plan.seed = map.count("seed", plan.seed);
  plan.tables = TABLE_USES.read(map, plan.tables);
  plan.save_every = static_cast<std::uint64_t>(map.whole("save_every", 0, INT64_MAX, 0));
  plan.side_by_side = static_cast<std::uint32_t>(map.whole("side_by_side", 1, 1024, plan.side_by_side));
  plan.turn = static_cast<std::uint32_t>(map.whole("turn", 1, INT32_MAX, plan.turn));
  plan.scenarios = findScenarios(map.need("scenarios"), map.placeOf("scenarios"));
  return plan;
}

}  // namespace

TrainingConfig readTrainingConfig(const std::string& file, FileKinds kinds) {
  const std::vector<YAML::Node> documents = loadYamlStream(file, kinds);
  if (documents.size() != 1) {
    throw InputError(file + ": expected one YAML document, got " + std::to_string(documents.size()));
  }
  const YamlMap map(documents.front(), {file, 0, ""},
                    {"state_set", "action_set", "reward", "vision", "learning", "training"});
  TrainingConfig config;
  config.model = readModel(map);
  config.learning = readLearningPlan(map.need("learning"), map.placeOf("learning"));
  config.training = readTrainingPlan(map.need("training"), map.placeOf("training"));
  return config;
}

}  // namespace crowd
