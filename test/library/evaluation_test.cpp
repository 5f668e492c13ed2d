#include "social_crowd/evaluation.h"

#include <gtest/gtest.h>

#include "simulation/evaluation/metrics.h"
#include "social_crowd/errors.h"
#include "support/evaluations.h"

namespace crowd::library::evaluation_test {
namespace {

QTable restlessTable() { return QTable(std::make_shared<TrainedTable>(evaluations::restlessTable())); }
Scenario scenarios() { return Scenario::parse(evaluations::SCENARIOS, "scenarios.yaml"); }

TEST(LibraryEvaluation, MeansAreThoseOfTheClassesBehindIt) {
  Metrics expected;
  for (const EvaluatedEpisode& walked : evaluations::evaluateAll(evaluations::planOf(9, 1, 4))) {
    expected.add(walked.result);
  }
  for (const unsigned threads : {1U, 3U, 0U}) {
    SCOPED_TRACE(threads);
    EvaluationOptions options;
    options.episodes = 9;
    options.seed = 4;
    options.threads = threads;
    const Means means = evaluate(restlessTable(), scenarios(), options);
    EXPECT_EQ(means.episodes, 9U);
    EXPECT_EQ(means.success_percent, expected.successPercent());
    EXPECT_EQ(means.contact_percent, expected.contactPercent());
    EXPECT_EQ(means.collision_percent, expected.collisionPercent());
    EXPECT_EQ(means.clean_percent, expected.cleanPercent());
    EXPECT_EQ(means.turn_per_metre, expected.turnPerMetre());
    EXPECT_EQ(means.max_speed_ratio, expected.maxSpeedRatio());
    EXPECT_EQ(means.blocked_moves, expected.blockedMovesPerAgent());
  }
}

TEST(LibraryEvaluation, AnAgentAloneWalksStraightAhead) {
  const Scenario scenario = Scenario::parse(
      "name: alone\nduration: 20\ngoal_tolerance: 0.5\n"
      "agents:\n  - {position: [0, 0], goal: [6, 0], speed: 1, radius: 0.25}\n",
      "alone.yaml");
  const Means means = evaluate(QTable::load("anticipation"), scenario);
  EXPECT_EQ(means.episodes, 1U);
  EXPECT_EQ(means.success_percent, 100.0);
  EXPECT_EQ(means.contact_percent, 0.0);
  EXPECT_EQ(means.clean_percent, 100.0);
  EXPECT_NEAR(means.path_ratio, 1.0, 0.02);
  EXPECT_NEAR(means.max_speed_ratio, 1.0, 1e-9);
}

TEST(LibraryEvaluation, DeliversEpisodesInTheirOrderUntilItIsStopped) {
  std::vector<std::string> names;
  EvaluationOptions options;
  options.episodes = 30;
  options.on_episode = [&](const EpisodeResult& result) {
    names.push_back(result.scenario);
    return names.size() < 4;
  };
  EXPECT_EQ(evaluate(restlessTable(), scenarios(), options).episodes, 4U);
  EXPECT_EQ(names, (std::vector<std::string>{"long", "short", "middle", "long"}));
}

TEST(LibraryEvaluation, Errors) {
  EvaluationOptions options;
  options.on_episode = [](const EpisodeResult&) -> bool { throw FileError("mine"); };
  EXPECT_THROW(evaluate(restlessTable(), scenarios(), options), FileError);
  options = {};
  options.robot_controller = "magic";
  EXPECT_THROW(evaluate(restlessTable(), Scenario::load("robot_circle_5"), options), InputError);
}

}  // namespace
}  // namespace crowd::library::evaluation_test
