// Several learners side by side, merged turn by turn.

#include <gtest/gtest.h>

#include "learning/rl/merge_copies.h"
#include "scenario/reading/scenario_reader.h"
#include "support/error_of.h"
#include "support/run_scene.h"
#include "support/temporary_folder.h"
#include "training/training.h"

namespace crowd::side_by_side_test {
namespace {

/// Three agents that cross a ring around an obstacle, 30 ticks at most; two documents.
std::string scenarios() {
  const std::string rest =
      "duration: 3\n"
      "goal_tolerance: 0.3\n"
      "agents: [{count: 3, position: {ring: {centre: [0, 0], radius: [1, 2]}}, goal: {opposite: [0, 0]}, speed: 1.2,\n"
      "          radius: 0.2, heading: [-180, 180]}]\n"
      "obstacles: [{position: [0, 0], radius: 0.2}]\n";
  return "name: first\n" + rest + "---\nname: second\n" + rest;
}

class SideBySide : public testing::Test {
 protected:
  SideBySide() { folder_.write("s.yaml", scenarios()); }

  TrainingConfig config(std::uint64_t episodes, const std::string& training,
                        const std::string& learning = "alpha: 0.1") const {
    return readTrainingConfig(folder_.write("config.yaml",
                                            "state_set: {type: nearest_obstacle}\n"
                                            "action_set: {type: kings_moves}\n"
                                            "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"
                                            "learning: {gamma: 0.5, epsilon: {from: 0.5, to: 0.1, episodes: 20}, " +
                                                learning +
                                                "}\n"
                                                "training: {scenarios: [s.yaml], seed: 5, episodes: " +
                                                std::to_string(episodes) + ", " + training + "}\n"));
  }

  static std::vector<EpisodeResult> finish(Training& training) {
    std::vector<EpisodeResult> results;
    while (!training.isDone()) {
      for (EpisodeResult& result : training.runNextTurn()) results.push_back(std::move(result));
    }
    return results;
  }

  TemporaryFolder folder_;
};

TEST_F(SideBySide, ResultDoesNotDependOnTheNumberOfThreads) {
  for (const char* const learning : {"alpha: 0.1", "alpha: 0.01, alpha_decay: 0.7, mirrored: true"}) {
    const auto train = [&](unsigned threads) {
      Training training(config(37, "side_by_side: 4, turn: 3", learning), threads);
      std::string ticks;
      for (const EpisodeResult& result : finish(training)) ticks += std::to_string(result.agents[0].ticks) + " ";
      return toText(training.trained()) + ticks;
    };
    const std::string one = train(1);
    EXPECT_EQ(train(2), one);
    EXPECT_EQ(train(7), one);
  }
}

TEST_F(SideBySide, ResultDependsOnSeedAndNumberOfLearners) {
  const auto train = [&](const std::string& plan, std::uint64_t seed) {
    TrainingConfig changed = config(24, plan);
    changed.training.seed = seed;
    Training training(changed, 2);
    finish(training);
    return training.trained().table;
  };
  const QTable table = train("side_by_side: 4, turn: 3", 1);
  EXPECT_EQ(train("side_by_side: 4, turn: 3", 1), table);
  EXPECT_NE(train("side_by_side: 4, turn: 3", 2), table);
  EXPECT_NE(train("side_by_side: 3, turn: 3", 1), table);
  EXPECT_NE(train("side_by_side: 4, turn: 2", 1), table);
}

TEST_F(SideBySide, OneLearnerAgreesWithSequentialTraining) {
  const TrainingConfig plain = config(12, "save_every: 0");
  Training training(config(12, "side_by_side: 1, turn: 3"), 7);
  EXPECT_EQ(training.runNextTurn().size(), 1U);
  finish(training);
  Learner::Options options;
  options.mode = Mode::TRAINING;
  options.seed = plain.training.seed;
  options.plan = plain.learning;
  Learner learner(plain.model, options);
  const ScenarioList list = parseScenarios(scenarios(), "s.yaml");
  for (std::uint64_t episode = 0; episode < 12; ++episode) runScene(list.scene(5, episode), episode, learner);
  EXPECT_EQ(training.trained().table, learner.tables().of(0));
  EXPECT_EQ(training.trained().decisions, learner.decisions());
  EXPECT_EQ(training.trained().parameters.epsilon, learner.parameters().epsilon);
}

TEST_F(SideBySide, TurnsMergeTheTablesOfAllLearners) {
  const TrainingConfig two = config(5, "side_by_side: 2, turn: 2");
  Training training(two, 2);
  const ScenarioList list = parseScenarios(scenarios(), "s.yaml");
  Learner::Options options;
  options.mode = Mode::TRAINING;
  options.seed = two.training.seed;
  options.plan = two.learning;
  // Turns by hand: learner 1 has episodes 0, 1 and then 4, learner 2 has episodes 2, 3.
  QTable expected(two.model.state_set->rowCount(), two.model.action_set->size());
  std::uint64_t decisions = 0;
  for (const auto& turn : std::vector<std::vector<std::vector<std::uint64_t>>>{{{0, 1}, {2, 3}}, {{4}, {}}}) {
    std::vector<QTable> tables;
    for (const std::vector<std::uint64_t>& episodes : turn) {
      Learner learner(two.model, options, expected);
      for (const std::uint64_t episode : episodes) runScene(list.scene(5, episode), episode, learner);
      tables.push_back(learner.tables().of(0));
      decisions += learner.decisions();
    }
    mergeCopies({&tables[0], &tables[1]}, LearningRateSchedule(two.learning.parameters), 0, expected.rows(), expected);
    EXPECT_EQ(training.runNextTurn().size(), turn[0].size() + turn[1].size());
    EXPECT_EQ(training.trained().table, expected);
    EXPECT_EQ(training.trained().decisions, decisions);
    EXPECT_EQ(training.decisions(), decisions);
  }
  EXPECT_TRUE(training.isDone());
  EXPECT_EQ(training.trained().parameters.epsilon, two.learning.epsilon.at(4));
}

TEST_F(SideBySide, ReturnsResultsInTheOrderOfTheEpisodes) {
  Training training(config(11, "side_by_side: 3, turn: 3"), 2);
  std::string names;
  for (const EpisodeResult& result : finish(training)) names += result.scenario + " ";
  EXPECT_EQ(names, "first second first second first second first second first second first ");
  EXPECT_EQ(training.episode(), 11U);
}

TEST_F(SideBySide, CountsOneVisitPerDecision) {
  Training training(config(24, "side_by_side: 4, turn: 2"), 2);
  finish(training);
  const TrainedTable trained = training.trained();
  std::uint64_t visits = 0;
  for (Row row = 0; row < trained.table.rows(); ++row) {
    for (Action action = 0; action < trained.table.actions(); ++action) visits += trained.table.visits(row, action);
  }
  EXPECT_EQ(visits, trained.decisions);
  EXPECT_GT(visits, 24U);
}

TEST_F(SideBySide, ContinuesFromATable) {
  Training first(config(4, "side_by_side: 2, turn: 2"), 1);
  finish(first);
  const TrainedTable begin = first.trained();
  Training more(config(4, "side_by_side: 2, turn: 2"), begin, 1);
  EXPECT_EQ(more.trained().table, begin.table);
  EXPECT_EQ(more.decisions(), 0U);
  finish(more);
  EXPECT_EQ(more.trained().decisions, begin.decisions + more.decisions());
  EXPECT_NE(more.trained().table, begin.table);
}

TEST_F(SideBySide, RefusesTracesAndOwnTables) {
  const auto error = [&](const std::string& training, const std::string& learning) {
    return errorOf<InputError>([&] { Training(config(4, training, learning)); });
  };
  EXPECT_EQ(error("side_by_side: 2", "lambda: 0.5"),
            "training.side_by_side: expected 1 with traces (learning.lambda above 0), got 2");
  EXPECT_EQ(error("side_by_side: 2, tables: own", "lambda: 0"),
            "training.side_by_side: expected 1 with own tables, got 2");
  EXPECT_EQ(error("side_by_side: 1, tables: own", "lambda: 0.5"), "no error");
}

TEST_F(SideBySide, UsesOneLearnerByDefault) {
  EXPECT_EQ(config(1, "tables: shared").training.side_by_side, 1U);
  EXPECT_EQ(config(1, "side_by_side: 6, turn: 7").training.side_by_side, 6U);
  EXPECT_EQ(config(1, "side_by_side: 6, turn: 7").training.turn, 7U);
  const auto error = [&](const std::string& training) { return errorOf<InputError>([&] { config(1, training); }); };
  EXPECT_TRUE(contains(error("side_by_side: 0"), "training.side_by_side: expected"));
  EXPECT_TRUE(contains(error("turn: 0"), "training.turn: expected"));
}

}  // namespace
}  // namespace crowd::side_by_side_test
