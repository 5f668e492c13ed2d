#include "simulation/evaluation/evaluation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "scenario/reading/scenario_reader.h"
#include "support/evaluations.h"

namespace crowd::evaluation_test {
namespace {

using evaluations::evaluateAll;
using evaluations::expectSame;
using evaluations::planOf;
using evaluations::restlessTable;
using evaluations::scenarios;

TEST(Evaluation, ResultsDoNotDependOnTheNumberOfThreads) {
  const std::vector<EvaluatedEpisode> expected = evaluateAll(planOf(30, 1));
  ASSERT_EQ(expected.size(), 30U);
  for (const unsigned threads : {2U, 7U}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    const std::vector<EvaluatedEpisode> all = evaluateAll(planOf(30, threads));
    ASSERT_EQ(all.size(), expected.size());
    for (std::size_t i = 0; i < all.size(); ++i) expectSame(all[i], expected[i]);
  }
}

TEST(Evaluation, PlaysTheScenariosInTurn) {
  const std::vector<EvaluatedEpisode> all = evaluateAll(planOf(7, 2));
  ASSERT_EQ(all.size(), 7U);
  const std::vector<std::string> names = {"long", "short", "middle"};
  for (std::uint64_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].instance, i);
    EXPECT_EQ(all[i].result.scenario, names[i % 3]);
  }
  EXPECT_NE(all[1].ticks.trajectory.substr(2), all[4].ticks.trajectory.substr(2));  // places differ between episodes
}

TEST(Evaluation, PlaysEachScenarioOnceByDefault) {
  EXPECT_EQ(evaluateAll(planOf(0, 1)).size(), 3U);
  EXPECT_EQ(evaluateAll(planOf(0, 7)).size(), 3U);  // more threads than work
}

TEST(Evaluation, AnyEpisodeIsRepeatedAlone) {
  const std::vector<EvaluatedEpisode> all = evaluateAll(planOf(9, 2));
  for (const std::uint64_t first : {0U, 4U, 8U}) {
    for (const unsigned threads : {1U, 3U}) {
      EvaluationPlan plan = planOf(9 - first, threads);
      plan.first = first;
      const std::vector<EvaluatedEpisode> some = evaluateAll(plan);
      ASSERT_EQ(some.size(), 9 - first);
      for (std::size_t i = 0; i < some.size(); ++i) expectSame(some[i], all[first + i]);
    }
  }
}

TEST(Evaluation, DrawnPlacesDependOnTheSeed) {
  const std::vector<EvaluatedEpisode> one = evaluateAll(planOf(1, 1, 1));
  const std::vector<EvaluatedEpisode> other = evaluateAll(planOf(1, 1, 2));
  EXPECT_NE(one.at(0).ticks.trajectory, other.at(0).ticks.trajectory);
}

TEST(Evaluation, DeliversScenesOnRequest) {
  EvaluationPlan plan = planOf(6, 2);
  EXPECT_EQ(evaluateAll(plan).at(0).scene, "");
  plan.scenes = ".";
  std::string documents;
  for (const EvaluatedEpisode& walked : evaluateAll(plan)) documents += walked.scene;
  const ScenarioList drawn = parseScenarios(documents, "drawn.yaml");
  ASSERT_EQ(drawn.size(), 6U);
  for (std::uint64_t i = 0; i < drawn.size(); ++i) {
    // The drawn scenes do not depend on the seed.
    const Scene scene = drawn.scene(1234, i);
    const Scene expected = scenarios().scene(plan.seed, i);
    EXPECT_EQ(scene.name, expected.name);
    ASSERT_EQ(scene.agents.size(), expected.agents.size());
    for (std::size_t k = 0; k < scene.agents.size(); ++k) {
      EXPECT_EQ(scene.agents[k].position, expected.agents[k].position);
    }
  }
}

/// The goal of the second scenario's agent is in a closed room.
TEST(Evaluation, WarnsOfGoalsOutOfReachWhenAnEpisodeBegins) {
  const std::string head = "name: n\nduration: 1\ngoal_tolerance: 0.1\n";
  const std::string free = head + "agents: [{position: [0, 0], goal: [5, 0], speed: 1, radius: 0.2}]\n";
  const std::string room = "walls: [[[4, -1], [6, -1]], [[6, -1], [6, 1]], [[6, 1], [4, 1]], [[4, 1], [4, -1]]]\n";
  const ScenarioList list = parseScenarios(free + "---\n" + free + room, "s.yaml");
  for (const unsigned threads : {1U, 3U}) {
    EvaluationPlan plan = planOf(4, threads);
    std::set<std::string> warnings;
    plan.warn = [&](std::uint64_t instance, const std::string& warning) {
      warnings.insert(std::to_string(instance) + ": " + warning);
    };
    std::string delivered;
    evaluate(restlessTable(), list, plan, [&](EvaluatedEpisode& walked) {
      delivered += std::to_string(walked.instance) + ": " + walked.result.wayWarning() + "; ";
      EXPECT_TRUE(walked.instance != 1 || warnings.count("1: 1 agent has a goal out of reach (0)") == 1);
      return true;
    });
    const std::string text = "1 agent has a goal out of reach (0)";
    EXPECT_EQ(warnings, (std::set<std::string>{"1: " + text, "3: " + text}));
    EXPECT_EQ(delivered, "0: ; 1: " + text + "; 2: ; 3: " + text + "; ");
  }
}

TEST(Evaluation, TrajectoryHasARowForEveryAgentAndTick) {
  const std::vector<EvaluatedEpisode> all = evaluateAll(planOf(3, 1));
  for (const EvaluatedEpisode& walked : all) {
    std::uint64_t expected = 0;
    for (const AgentResult& agent : walked.result.agents) expected += agent.ticks + 1;  // tick 0 is one of them
    const auto rows = std::count(walked.ticks.trajectory.begin(), walked.ticks.trajectory.end(), '\n');
    EXPECT_EQ(static_cast<std::uint64_t>(rows), expected);
    EXPECT_EQ(walked.ticks.trajectory.find(std::to_string(walked.instance) + ",0,0,"), 0U);
  }
}

TEST(Evaluation, DeliversTrajectoriesOnlyOnRequest) {
  EvaluationPlan plan = planOf(3, 1);
  plan.record = false;
  for (const EvaluatedEpisode& walked : evaluateAll(plan)) EXPECT_TRUE(walked.ticks.trajectory.empty());
}

TEST(Evaluation, AgentsFollowTheTable) {
  // Without obstacles and with the goal ahead, an empty table selects action 0, straight on.
  TrainedTable trained = restlessTable();
  trained.table = QTable(137, 8);
  const ScenarioList line = parseScenarios(
      "{name: line, duration: 10, goal_tolerance: 0.25, agents: [{position: [0, 0], goal: [3, 0], speed: 1, "
      "radius: 0.2}]}",
      "line.yaml");
  EpisodeResult ahead;
  evaluate(trained, line, planOf(1, 1), [&](EvaluatedEpisode& walked) {
    ahead = walked.result;
    return true;
  });
  EXPECT_EQ(ahead.arrivedCount(), 1U);
  EXPECT_EQ(ahead.ticks, 28U);
  // If action 4 is the best in all rows, the agent turns around in each tick.
  for (Row row = 0; row < trained.table.rows(); ++row) trained.table.set(row, 4, 1.0, 1);
  EpisodeResult back;
  evaluate(trained, line, planOf(1, 1), [&](EvaluatedEpisode& walked) {
    back = walked.result;
    return true;
  });
  EXPECT_EQ(back.arrivedCount(), 0U);
  EXPECT_EQ(back.ticks, 100U);
  EXPECT_NEAR(back.agents.at(0).turn_per_metre, 99 * PI / 10.0, 1e-6);
}

TEST(Evaluation, StopsWhenTheReceiverReturnsFalse) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    std::vector<std::uint64_t> delivered;
    evaluate(restlessTable(), scenarios(), planOf(30, threads), [&](EvaluatedEpisode& walked) {
      delivered.push_back(walked.instance);
      return delivered.size() < 4;
    });
    EXPECT_EQ(delivered, (std::vector<std::uint64_t>{0, 1, 2, 3}));
  }
}

const char* const KEPT =
    "name: kept\n"
    "duration: 3\n"
    "order: sequential\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {count: 2, position: {box: [[-2, -2], [2, 2]]}, goal: {box: [[-2, -2], [2, 2]]}, speed: 1, radius: 0.2,\n"
    "     heading: kept}\n";

std::vector<EvaluatedEpisode> evaluateKept(unsigned threads) {
  EvaluationPlan plan = planOf(5, threads);
  plan.scenes = ".";
  std::vector<EvaluatedEpisode> all;
  evaluate(restlessTable(), parseScenarios(KEPT, "kept.yaml"), plan, [&](EvaluatedEpisode& walked) {
    all.push_back(std::move(walked));
    return true;
  });
  return all;
}

TEST(Evaluation, KeptHeadingsComeFromThePreviousEpisode) {
  const std::vector<EvaluatedEpisode> all = evaluateKept(1);
  ASSERT_EQ(all.size(), 5U);
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Scene scene = parseScenarios(all[i].scene, "drawn.yaml").scene(1, 0);
    for (std::size_t agent = 0; agent < 2; ++agent) {
      const double before = all[i - 1].result.agents[agent].heading;
      EXPECT_NEAR(wrapAngle(scene.agents[agent].heading - before), 0.0, 1e-12);
    }
  }
  const std::vector<EvaluatedEpisode> again = evaluateKept(4);
  for (std::size_t i = 0; i < all.size(); ++i) expectSame(again[i], all[i]);
}

TEST(Evaluation, RecordsAStateForEachDecision) {
  EvaluationPlan plan = planOf(3, 1);
  plan.states = true;
  const std::vector<EvaluatedEpisode> all = evaluateAll(plan);
  const std::vector<EvaluatedEpisode> plain = evaluateAll(planOf(3, 1));
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::uint64_t decisions = 0;
    for (const AgentResult& agent : all[i].result.agents) decisions += agent.ticks;
    EXPECT_EQ(std::count(all[i].states.begin(), all[i].states.end(), '\n'), static_cast<std::ptrdiff_t>(decisions));
    expectSame(all[i], plain[i]);
    EXPECT_TRUE(plain[i].states.empty());
  }
}

}  // namespace
}  // namespace crowd::evaluation_test
