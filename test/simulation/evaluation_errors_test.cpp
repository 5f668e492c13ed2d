// Errors during an evaluation, and evaluations without scenarios.

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulation/evaluation/evaluation.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"
#include "support/evaluations.h"

namespace crowd::evaluation_errors_test {
namespace {

using evaluations::planOf;
using evaluations::restlessTable;
using evaluations::scenarios;

/// Receives episodes and checks that instances arrive in order from 0.
class InOrder {
 public:
  bool operator()(EvaluatedEpisode& walked) {
    EXPECT_EQ(walked.instance, count_);
    ++count_;
    return true;
  }
  std::uint64_t count() const { return count_; }

 private:
  std::uint64_t count_ = 0;
};

TEST(Evaluation, ErrorOfASceneReachesTheCaller) {
  // The third scenario has no room for its agents; the scenario reader would refuse it.
  const ScenarioList read = scenarios();
  std::vector<Scenario> crowded = {read[0], read[1], read[2]};
  crowded[2].agents[0].count = 500;
  for (const unsigned threads : {1U, 2U, 7U}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    InOrder in_order;
    const std::string message = errorOf<InputError>(
        [&] { evaluate(restlessTable(), ScenarioList(crowded), planOf(12, threads), std::ref(in_order)); });
    EXPECT_TRUE(contains(message, "scenarios.yaml: document 3")) << message;
    EXPECT_LE(in_order.count(), 2U);
  }
}

TEST(Evaluation, DeliversEpisodesBeforeAnError) {
  const ScenarioList read = scenarios();
  std::vector<Scenario> crowded = {read[0], read[1], read[2]};
  crowded[2].agents[0].count = 500;
  InOrder in_order;
  EXPECT_THROW(evaluate(restlessTable(), ScenarioList(crowded), planOf(12, 1), std::ref(in_order)), InputError);
  EXPECT_EQ(in_order.count(), 2U);
}

TEST(Evaluation, ErrorOfATableOfTheWrongShapeReachesTheCaller) {
  TrainedTable trained = restlessTable();
  trained.table = QTable(5, 8);
  for (const unsigned threads : {1U, 7U}) {
    InOrder in_order;
    EXPECT_THROW(evaluate(trained, scenarios(), planOf(12, threads), std::ref(in_order)), ShapeError);
    EXPECT_EQ(in_order.count(), 0U);
  }
}

TEST(Evaluation, ErrorOfTheReceiverReachesTheCaller) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    SCOPED_TRACE(std::to_string(threads) + " threads");
    int calls = 0;
    const auto deliver = [&](EvaluatedEpisode&) -> bool {
      if (++calls == 3) throw std::runtime_error("the disk is full");
      return true;
    };
    EXPECT_THROW(evaluate(restlessTable(), scenarios(), planOf(30, threads), deliver), std::runtime_error);
    EXPECT_EQ(calls, 3);  // not called again
  }
}

TEST(Evaluation, PlaysNoEpisodeWithoutScenarios) {
  InOrder in_order;
  evaluate(restlessTable(), ScenarioList(), planOf(0, 2), std::ref(in_order));
  EXPECT_EQ(in_order.count(), 0U);
  EXPECT_THROW(evaluate(restlessTable(), ScenarioList(), planOf(1, 2), std::ref(in_order)), InputError);
}

}  // namespace
}  // namespace crowd::evaluation_errors_test
