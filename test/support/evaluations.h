#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "learning/q_table_file.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/evaluation/evaluation.h"

/// Scenarios, a table and plans for tests of evaluations.
namespace crowd::evaluations {

/// Scenarios of different lengths, so that threads finish episodes out of order.
inline const char* const SCENARIOS =
    "name: long\n"
    "duration: 12\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {count: 8, position: {box: [[-3, -3], [3, 3]]}, goal: {box: [[-3, -3], [3, 3]]}, speed: [0.8, 1.6],\n"
    "     radius: 0.25}\n"
    "obstacles:\n"
    "  - {count: 2, position: {box: [[-3, -3], [3, 3]]}, radius: 0.3}\n"
    "---\n"
    "name: short\n"
    "duration: 1\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {position: {ring: {centre: [0, 0], radius: 2}}, goal: {opposite: [0, 0]}, speed: 1, radius: 0.25}\n"
    "---\n"
    "name: middle\n"
    "duration: 5\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {count: 3, position: {box: [[-2, -2], [2, 2]]}, goal: {opposite: [0, 0]}, speed: 1.3, radius: 0.25}\n";

inline ScenarioList scenarios() { return parseScenarios(SCENARIOS, "scenarios.yaml"); }

/// A table with random values, so that agents act differently in each row.
inline TrainedTable restlessTable() {
  TrainedTable trained{parseModel("state_set: {type: nearest_obstacle}\n"
                                  "action_set: {type: kings_moves}\n"
                                  "reward: {goal: cosine_cubed, obstacle_cost: 80}\n"),
                       LearningParameters(), 1, 1, QTable(137, 8)};
  KeyedRandom random(1, KeyedRandom::EXPLORATION, {});
  for (Row row = 0; row < trained.table.rows(); ++row) {
    for (Action action = 0; action < trained.table.actions(); ++action) {
      trained.table.set(row, action, random.uniform(), 1);
    }
  }
  return trained;
}

inline EvaluationPlan planOf(std::uint64_t episodes, unsigned threads, std::uint64_t seed = 1) {
  EvaluationPlan plan;
  plan.episodes = episodes;
  plan.threads = threads;
  plan.seed = seed;
  plan.record = true;
  return plan;
}

/// All episodes of the plan, with the random table and the scenarios above.
inline std::vector<EvaluatedEpisode> evaluateAll(const EvaluationPlan& plan) {
  std::vector<EvaluatedEpisode> all;
  evaluate(restlessTable(), scenarios(), plan, [&](EvaluatedEpisode& walked) {
    all.push_back(std::move(walked));
    return true;
  });
  return all;
}

/// The result of the first episode of a scenario with the table `anticipation`.
inline EpisodeResult evaluateOnce(const std::string& scenario, const EvaluationPlan& plan) {
  EpisodeResult result;
  evaluate(loadQTable(SOURCE_DIR "/config/q_tables/anticipation.txt"), parseScenarios(scenario, "s.yaml"), plan,
           [&](EvaluatedEpisode& walked) {
             result = walked.result;
             return true;
           });
  return result;
}

/// Requires equal results and trajectories, bit for bit.
inline void expectSame(const EvaluatedEpisode& walked, const EvaluatedEpisode& expected) {
  SCOPED_TRACE("instance " + std::to_string(expected.instance));
  EXPECT_EQ(walked.instance, expected.instance);
  EXPECT_EQ(walked.ticks.trajectory, expected.ticks.trajectory);
  EXPECT_EQ(walked.result.scenario, expected.result.scenario);
  EXPECT_EQ(walked.result.ticks, expected.result.ticks);
  ASSERT_EQ(walked.result.agents.size(), expected.result.agents.size());
  for (std::size_t i = 0; i < expected.result.agents.size(); ++i) {
    const AgentResult& agent = walked.result.agents[i];
    const AgentResult& other = expected.result.agents[i];
    EXPECT_EQ(agent.arrived, other.arrived);
    EXPECT_EQ(agent.touched, other.touched);
    EXPECT_EQ(agent.ticks, other.ticks);
    EXPECT_EQ(agent.path_length, other.path_length);
    EXPECT_EQ(agent.turn_per_metre, other.turn_per_metre);
    EXPECT_EQ(agent.max_speed_ratio, other.max_speed_ratio);
  }
}

}  // namespace crowd::evaluations
