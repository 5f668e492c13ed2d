#include "training/training_config.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/temporary_folder.h"

namespace crowd::training_config_test {
namespace {

const char* const CONFIG =
    "# a comment\n"                                                      // line 1
    "state_set: {type: nearest_obstacle, goal_sectors: 4}\n"             // line 2
    "action_set: {type: kings_moves, rotations: 6}\n"                    // line 3
    "reward: {goal: distance_gained, arrival: 50, obstacle_cost: 20}\n"  // line 4
    "learning:\n"                                                        // line 5
    "  alpha: 0.2\n"                                                     // line 6
    "  gamma: 0.5\n"                                                     // line 7
    "  lambda: 0.25\n"                                                   // line 8
    "  epsilon: {from: 0.8, to: 0.2, episodes: 10}\n"                    // line 9
    "training:\n"                                                        // line 10
    "  scenarios: [a.yaml, ../b.yaml, sub/./c.yaml, circle6]\n"          // line 11
    "  episodes: 300\n"                                                  // line 12
    "  seed: 77\n"                                                       // line 13
    "  tables: own\n"                                                    // line 14
    "  save_every: 25\n";                                                // line 15

/// A folder that contains CONFIG as `learning/r.yaml`, and all scenario files that it names.
class ConfigFolder {
 public:
  ConfigFolder() {
    std::filesystem::create_directories(folder_.file("learning/sub"));
    for (const char* name : {"learning/a.yaml", "b.yaml", "learning/sub/c.yaml"}) folder_.write(name, "");
    file_ = folder_.write("learning/r.yaml", CONFIG);
  }

  std::string file(const std::string& name) const { return folder_.file(name); }
  const std::string& config() const { return file_; }

 private:
  TemporaryFolder folder_;
  std::string file_;
};

std::string replaced(const std::string& from, const std::string& to) {
  std::string text = CONFIG;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(TrainingConfig, ReadsModelLearningAndTraining) {
  const TrainingConfig config = readTrainingConfig(ConfigFolder().config());
  EXPECT_EQ(config.model.action_set->size(), 6U);
  EXPECT_EQ(config.model.state_set->rowCount(), 4U * 8U * 2U + 4U + 1U);  // sectors, classes, none, arrived
  EXPECT_EQ(config.model.reward->spec(), "{goal: distance_gained, arrival: 50, obstacle_cost: 20}");
  EXPECT_EQ(config.learning.parameters.alpha, 0.2);
  EXPECT_EQ(config.learning.parameters.gamma, 0.5);
  EXPECT_EQ(config.learning.parameters.lambda, 0.25);
  EXPECT_EQ(config.learning.parameters.epsilon, 0.8);
  EXPECT_DOUBLE_EQ(config.learning.epsilon.at(5), 0.5);
  EXPECT_DOUBLE_EQ(config.learning.epsilon.at(10), 0.2);
  EXPECT_EQ(config.training.episodes, 300U);
  EXPECT_EQ(config.training.seed, 77U);
  EXPECT_EQ(config.training.tables, TableUse::OWN);
  EXPECT_EQ(config.training.save_every, 25U);
}

TEST(TrainingConfig, ScenariosAreRelativePathsOrNames) {
  const ConfigFolder folder;
  const TrainingConfig config = readTrainingConfig(folder.config());
  const std::vector<std::string> expected = {folder.file("learning/a.yaml"), folder.file("b.yaml"),
                                             folder.file("learning/sub/c.yaml"),
                                             std::string(SOURCE_DIR) + "/config/scenarios/circle6.yaml"};
  EXPECT_EQ(config.training.scenarios, expected);
}

TEST(TrainingConfig, UsesDefaultsForMissingKeys) {
  const TemporaryFolder folder;
  folder.write("s.yaml", "");
  const TrainingConfig config = readTrainingConfig(folder.write("r.yaml",
                                                                "state_set: {type: nearest_obstacle}\n"
                                                                "action_set: {type: kings_moves}\n"
                                                                "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"
                                                                "learning: {}\n"
                                                                "training: {scenarios: [s.yaml], episodes: 1}\n"));
  EXPECT_EQ(config.model.state_set->rowCount(), 137U);  // the thesis's
  EXPECT_EQ(config.model.action_set->size(), 8U);
  EXPECT_EQ(config.learning.parameters.alpha, 0.1);
  EXPECT_EQ(config.learning.parameters.gamma, 0.1);
  EXPECT_EQ(config.learning.parameters.lambda, 0.0);
  EXPECT_EQ(config.learning.epsilon.at(1000), 0.1);
  EXPECT_EQ(config.training.seed, 1U);
  EXPECT_EQ(config.training.tables, TableUse::SHARED);
  EXPECT_EQ(config.training.save_every, 0U);
}

struct Mistake {
  std::string from;
  std::string to;
  std::vector<std::string> parts;  // of the message, beside the file
};

void expectRefused(const Mistake& mistake) {
  SCOPED_TRACE(mistake.from + " -> " + mistake.to);
  const TemporaryFolder folder;
  const std::string file = folder.write("wrong.yaml", replaced(mistake.from, mistake.to));
  const std::string message = errorOf<InputError>([&] { readTrainingConfig(file); });
  EXPECT_EQ(message.find(file + ":"), 0U) << message;
  EXPECT_TRUE(contains(message, "line ")) << message;
  for (const std::string& part : mistake.parts) {
    EXPECT_TRUE(contains(message, part)) << "'" << message << "' lacks '" << part << "'";
  }
}

TEST(TrainingConfig, ErrorsContainFileLineAndExpectation) {
  const std::vector<Mistake> mistakes = {
      {"state_set: {type: nearest_obstacle, goal_sectors: 4}\n", "", {"state_set"}},
      {"nearest_obstacle", "farthest", {"line 2", "state_set.type", namesOf(stateSetTypes()), "farthest"}},
      {"goal_sectors: 4", "goal_sectors: many", {"line 2", "state_set.goal_sectors", "whole number", "many"}},
      {"goal_sectors", "sectors", {"line 2", "state_set", "unknown key 'sectors'", "goal_sectors"}},
      {"kings_moves", "queens_moves", {"line 3", "action_set.type", "kings_moves", "queens_moves"}},
      {"rotations: 6", "rotations: 1", {"line 3", "action_set.rotations", "2", "'1'"}},
      {"goal: distance_gained", "goal: fun", {"line 4", "reward.goal", "distance_gained or cosine_cubed", "fun"}},
      {"obstacle_cost: 20", "obstacle_cost: -1", {"line 4", "reward.obstacle_cost", "0 or more", "-1"}},
      {"learning:", "lerning:", {"line 5", "unknown key 'lerning', did you mean 'learning'? Known are state_set,"}},
      {"alpha: 0.2", "alfa: 0.2", {"line 6", "'alfa', did you mean 'alpha'? Known are alpha, alpha_decay, gamma,"}},
      {"gamma: 0.5", "gama: 0.5", {"line 7", "'gama', did you mean 'gamma'? Known are alpha, alpha_decay, gamma,"}},
      {"{type: nearest", "{typ: nearest", {"line 2", "state_set", "unknown key 'typ', did you mean 'type'?"}},
      {"{type: kings", "{tpye: kings", {"line 3", "action_set", "unknown key 'tpye', did you mean 'type'?"}},
      {"alpha: 0.2", "alpha: 1.5", {"line 6", "alpha", "above 0, at most 1", "1.5"}},
      {"lambda: 0.25", "lambda: .nan", {"line 8", "learning.lambda", "number", ".nan"}},
      {"from: 0.8", "from: 80", {"line 9", "learning.epsilon.from", "from 0 to 1", "80"}},
      {"episodes: 10", "episodes: 0", {"line 9", "learning.epsilon.episodes", "1", "'0'"}},
      {"episodes: 10", "episodes: 10, shape: round", {"line 9", "epsilon.shape", "linear or exponential", "round"}},
      {"scenarios: [", "files: [", {"line 11", "training", "unknown key 'files'; known are scenarios, episodes, seed"}},
      {"[a.yaml, ../b.yaml, sub/./c.yaml, circle6]",
       "a.yaml",
       {"line 11", "training.scenarios", "a list of scenario files", "a.yaml"}},
      {"[a.yaml, ../b.yaml, sub/./c.yaml, circle6]",
       "[]",
       {"line 11", "training.scenarios", "a list of scenario files"}},
      {"a.yaml", "{name: a.yaml}", {"line 11", "training.scenarios[0]", "expected", "a map"}},
      {"episodes: 300", "episodes: 0", {"line 12", "training.episodes", "1", "'0'"}},
      {"episodes: 300", "episodes: 2.5", {"line 12", "training.episodes", "whole number", "2.5"}},
      {"seed: 77", "seed: -1", {"line 13", "training.seed", "0", "-1"}},
      {"tables: own", "tables: borrowed", {"line 14", "training.tables", "shared or own", "borrowed"}},
      {"save_every: 25", "save_every: often", {"line 15", "training.save_every", "whole number", "often"}},
      {"save_every: 25", "seed: 78", {"line 15", "training", "seed"}},
      {"save_every", "save_often", {"line 15", "training", "unknown key 'save_often'", "save_every"}},
      {"# a comment", "color: red", {"line 1", "unknown key 'color'", "training"}},
      {"  alpha: 0.2", "  alpha: [0.2", {"line ", "YAML"}},
  };
  for (const Mistake& mistake : mistakes) expectRefused(mistake);
}

TEST(TrainingConfig, ErrorsContainTheLineOfALearningParameter) {
  expectRefused({"gamma: 0.5", "gamma: 1", {"line 7", "gamma", "from 0 to below 1", "1"}});
  expectRefused({"lambda: 0.25", "lambda: -1", {"line 8", "lambda", "from 0 to 1", "-1"}});
}

TEST(TrainingConfig, ErrorOfAMissingScenarioListsAlternatives) {
  const TemporaryFolder folder;
  std::string text = CONFIG;
  const std::string all = "[a.yaml, ../b.yaml, sub/./c.yaml, circle6]";
  text.replace(text.find(all), all.size(), "[circel6]");
  const std::string file = folder.write("r.yaml", text);
  const std::string message = errorOf<InputError>([&] { readTrainingConfig(file); });
  EXPECT_EQ(message.find(file +
                         ": line 11: training.scenarios[0]: no scenario 'circel6', did you mean 'circle6'? There "
                         "is no file " +
                         folder.file("circel6") + ", and in "),
            0U)
      << message;
}

TEST(TrainingConfig, RequiresOneDocument) {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& reason) {
    const std::string file = folder.write("wrong.yaml", text);
    const std::string message = errorOf<InputError>([&] { readTrainingConfig(file); });
    return message.find(file + ":") == 0 && contains(message, reason);
  };
  EXPECT_TRUE(refused(std::string(CONFIG) + "---\n" + CONFIG, "expected one YAML document, got 2"));
  EXPECT_TRUE(refused("", "expected one YAML document, got 0"));
  EXPECT_TRUE(refused("[1, 2]\n", "expected a map"));
}

TEST(TrainingConfig, ReportsAMissingFile) {
  const TemporaryFolder folder;
  const std::string message = errorOf<FileError>([&] { readTrainingConfig(folder.file("nowhere.yaml")); });
  EXPECT_TRUE(contains(message, folder.file("nowhere.yaml"))) << message;
  EXPECT_TRUE(contains(message, "No such file")) << message;
}

}  // namespace
}  // namespace crowd::training_config_test
