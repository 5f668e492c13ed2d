#include "ranks/distributed_evaluation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/text/numbers.h"
#include "support/error_of.h"
#include "support/evaluations.h"
#include "support/thread_ranks.h"

namespace crowd::distributed_evaluation_test {
namespace {

/// Agents that keep their heading, so that each episode depends on the one before it.
const char* const SCENARIOS =
    "name: first\n"
    "duration: 3\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {count: 20, position: {box: [[-20, -3], [20, 3]]}, goal: {box: [[-20, -3], [20, 3]]}, speed: [0.8, 1.6],\n"
    "     radius: 0.25, heading: kept}\n"
    "---\n"
    "name: second\n"
    "duration: 2\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {count: 20, position: {box: [[-20, -3], [20, 3]]}, goal: {box: [[-20, -3], [20, 3]]}, speed: 1,\n"
    "     radius: 0.25, heading: kept}\n";

std::vector<EvaluatedEpisode> evaluateOn(int ranks, const TrainedTable& trained, const ScenarioList& scenarios,
                                         const EvaluationPlan& plan, std::size_t most = SIZE_MAX) {
  std::vector<EvaluatedEpisode> all;
  ThreadRanks(ranks).run([&](Communicator& communicator) {
    const bool goes_on = evaluateOnRanks(communicator, trained, scenarios, plan, {}, [&](EvaluatedEpisode& walked) {
      EXPECT_EQ(communicator.rank(), 0);
      all.push_back(std::move(walked));
      return all.size() < most;
    });
    EXPECT_EQ(goes_on, most == SIZE_MAX);
  });
  return all;
}

TEST(EvaluateOnRanks, GivesWhatEvaluateGives) {
  const ScenarioList scenarios = parseScenarios(SCENARIOS, "s.yaml");
  const EvaluationPlan plan = evaluations::planOf(5, 1, 3);
  std::vector<EvaluatedEpisode> alone;
  evaluate(evaluations::restlessTable(), scenarios, plan, [&](EvaluatedEpisode& walked) {
    alone.push_back(std::move(walked));
    return true;
  });
  for (int ranks = 1; ranks <= 3; ++ranks) {
    const std::vector<EvaluatedEpisode> walked = evaluateOn(ranks, evaluations::restlessTable(), scenarios, plan);
    ASSERT_EQ(walked.size(), 5U);
    for (std::size_t i = 0; i < walked.size(); ++i) evaluations::expectSame(walked[i], alone[i]);
  }
}

/// Scenes that cannot be divided: ways round a wall, turns, robots, and a population.
const char* const WHOLE_SCENARIOS =
    "name: ways\n"
    "duration: 8\n"
    "goal_tolerance: 0.3\n"
    "walls: [[[-2, 0], [2, 0]]]\n"
    "agents:\n"
    "  - {count: 150, position: {box: [[-12, -8], [12, 8]]}, goal: {box: [[-12, -8], [12, 8]]}, speed: [0.8, 1.6],\n"
    "     radius: 0.25}\n"
    "---\n"
    "name: turns\n"
    "duration: 3\n"
    "goal_tolerance: 0.3\n"
    "order: sequential\n"
    "agents:\n"
    "  - {position: [-1, 3], goal: [-1, 2.5], speed: 1.3, radius: 0.25}\n"
    "  - {count: 6, position: {box: [[-3, -2], [3, 2]]}, goal: {opposite: [0, 0]}, speed: 1.3, radius: 0.25}\n"
    "---\n"
    "name: robots\n"
    "duration: 6\n"
    "goal_tolerance: 0.3\n"
    "agents:\n"
    "  - {count: 70, position: {box: [[-8, -8], [8, 8]]}, goal: {opposite: [0, 0]}, speed: 1.3, radius: 0.25}\n"
    "robots:\n"
    "  - {name: tug, position: [-9, 0], goal: [9, 0], radius: 0.3, max_speed: 1}\n"
    "---\n"
    "name: population\n"
    "duration: 10\n"
    "goal_tolerance: 0.3\n"
    "routes: {through: {waypoints: [{queue: till}, {sink: exit}]}}\n"
    "queues: {till: {head: [0, 0], direction: 180, spacing: 0.8, service: 1}}\n"
    "sinks: {exit: {area: {box: [[5, -1], [7, 1]]}}}\n"
    "sources:\n"
    "  - {area: {box: [[-8, -2], [-6, 2]]}, rate: 2, until: 8, route: through, speed: 1, radius: 0.25}\n";

TEST(EvaluateOnRanks, WalksScenesThatCannotBeDividedOnRankZero) {
  const ScenarioList scenarios = parseScenarios(WHOLE_SCENARIOS, "s.yaml");
  EvaluationPlan plan = evaluations::planOf(8, 1, 3);
  plan.robot_controller = "reactive";
  plan.people_delay = true;
  plan.states = true;
  const TrainedTable anticipation = loadQTable(SOURCE_DIR "/config/q_tables/anticipation.txt");
  std::vector<EvaluatedEpisode> alone;
  evaluate(anticipation, scenarios, plan, [&](EvaluatedEpisode& walked) {
    alone.push_back(std::move(walked));
    return true;
  });
  for (int ranks = 1; ranks <= 3; ++ranks) {
    const std::vector<EvaluatedEpisode> walked = evaluateOn(ranks, anticipation, scenarios, plan);
    ASSERT_EQ(walked.size(), 8U);
    for (std::size_t i = 0; i < walked.size(); ++i) {
      evaluations::expectSame(walked[i], alone[i]);
      EXPECT_EQ(walked[i].states, alone[i].states);
      ASSERT_EQ(walked[i].result.robots.size(), alone[i].result.robots.size());
      for (std::size_t robot = 0; robot < walked[i].result.robots.size(); ++robot) {
        EXPECT_EQ(walked[i].result.robots[robot].path_length, alone[i].result.robots[robot].path_length);
        EXPECT_EQ(toText(walked[i].result.robots[robot].people_delay),
                  toText(alone[i].result.robots[robot].people_delay));
      }
    }
  }
}

TEST(EvaluateOnRanks, EndsAWalkOfRankZeroWhenItIsToldTo) {
  ThreadRanks(2).run([&](Communicator& communicator) {
    std::uint64_t ticks = 0;
    RanksObserver observer;
    observer.on_tick = [&](std::uint64_t /*instance*/, std::uint64_t tick, std::uint64_t /*max_ticks*/) {
      ticks = tick;
    };
    EvaluationPlan plan = evaluations::planOf(8, 1);
    plan.stop = StopRequest([&] { return communicator.rank() == 0 && ticks == 5; });
    EXPECT_FALSE(evaluateOnRanks(communicator, evaluations::restlessTable(), parseScenarios(WHOLE_SCENARIOS, "s.yaml"),
                                 plan, observer,
                                 [](EvaluatedEpisode& /*walked*/) -> bool { throw Error("was not stopped"); }));
    EXPECT_EQ(ticks, communicator.rank() == 0 ? 5U : 0U);
  });
}

TEST(EvaluateOnRanks, TellsAllRanksOfAnErrorWhileRankZeroWalks) {
  ThreadRanks(2).run([&](Communicator& communicator) {
    RanksObserver observer;
    observer.on_tick = [](std::uint64_t /*instance*/, std::uint64_t /*tick*/, std::uint64_t /*max_ticks*/) {
      throw Error("no more ticks");
    };
    const std::string problem = errorOf<SharedError>([&] {
      evaluateOnRanks(communicator, evaluations::restlessTable(), parseScenarios(WHOLE_SCENARIOS, "s.yaml"),
                      evaluations::planOf(8, 1), observer, [](EvaluatedEpisode& /*walked*/) { return true; });
    });
    EXPECT_TRUE(contains(problem, "rank 0: no more ticks")) << problem;
  });
}

TEST(EvaluateOnRanks, EndsWhenItIsToldTo) {
  const ScenarioList scenarios = parseScenarios(SCENARIOS, "s.yaml");
  EXPECT_EQ(evaluateOn(2, evaluations::restlessTable(), scenarios, evaluations::planOf(5, 1), 2).size(), 2U);
  ThreadRanks(2).run([&](Communicator& communicator) {
    EvaluationPlan plan = evaluations::planOf(5, 1);
    plan.stop = StopRequest([&] { return communicator.rank() == 1; });
    const auto deliver = [](EvaluatedEpisode& /*walked*/) { return true; };
    EXPECT_FALSE(evaluateOnRanks(communicator, evaluations::restlessTable(), scenarios, plan, {}, deliver));
  });
}

TEST(EvaluateOnRanks, RequiresTheSameScenes) {
  ThreadRanks(2).run([&](Communicator& communicator) {
    const auto deliver = [](EvaluatedEpisode& /*walked*/) { return true; };
    EvaluationPlan plan = evaluations::planOf(1, 1);
    plan.seed = communicator.rank();
    const std::string problem = errorOf<SharedError>([&] {
      evaluateOnRanks(communicator, evaluations::restlessTable(), parseScenarios(SCENARIOS, "s.yaml"), plan, {},
                      deliver);
    });
    EXPECT_TRUE(contains(problem, "rank 1 differs from rank 0 in the scene of 'first'")) << problem;
  });
}

}  // namespace
}  // namespace crowd::distributed_evaluation_test
