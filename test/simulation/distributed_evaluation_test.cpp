#include "social_crowd/simulation/distributed_evaluation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/error_of.h"
#include "support/evaluations.h"
#include "support/thread_ranks.h"

namespace crowd {
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

std::vector<EvaluatedEpisode> evaluateOn(int ranks, const ScenarioList& scenarios, const EvaluationPlan& plan,
                                         std::size_t most = SIZE_MAX) {
  std::vector<EvaluatedEpisode> all;
  ThreadRanks(ranks).run([&](Communicator& communicator) {
    const bool goes_on =
        evaluateOnRanks(communicator, evaluations::restlessTable(), scenarios, plan, {}, [&](EvaluatedEpisode& walked) {
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
    const std::vector<EvaluatedEpisode> walked = evaluateOn(ranks, scenarios, plan);
    ASSERT_EQ(walked.size(), 5U);
    for (std::size_t i = 0; i < walked.size(); ++i) evaluations::expectSame(walked[i], alone[i]);
  }
}

TEST(EvaluateOnRanks, EndsWhenItIsToldTo) {
  const ScenarioList scenarios = parseScenarios(SCENARIOS, "s.yaml");
  EXPECT_EQ(evaluateOn(2, scenarios, evaluations::planOf(5, 1), 2).size(), 2U);
  ThreadRanks(2).run([&](Communicator& communicator) {
    RanksObserver observer;
    observer.is_stopped = [&] { return communicator.rank() == 1; };
    const auto deliver = [](EvaluatedEpisode& /*walked*/) { return true; };
    EXPECT_FALSE(evaluateOnRanks(communicator, evaluations::restlessTable(), scenarios, evaluations::planOf(5, 1),
                                 observer, deliver));
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
}  // namespace crowd
