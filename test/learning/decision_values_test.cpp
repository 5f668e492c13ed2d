#include "learning/decision_values.h"

#include <gtest/gtest.h>

#include "learning/learner.h"
#include "support/learners.h"

namespace crowd::decision_values_test {
namespace {

using learners::actionOf;
using learners::decide;
using learners::emptyTable;
using learners::goalIn;
using learners::model;
using learners::options;
using learners::tick;

/// In row 0 each action has 10 times its number as value, and 100 more than its number as visits.
QTable numbered() {
  QTable table = emptyTable();
  for (Action action = 0; action < 8; ++action) table.set(0, action, 10.0 * action, 100 + action);
  return table;
}

std::optional<DecisionValues> valuesOf(Learner& learner, const PerceptionsBuilder& scene, AgentId agent) {
  return learner.valuesOf(scene.all(), decide(learner, scene), agent);
}

TEST(DecisionValues, HasTheEntriesOfAllMoves) {
  Learner learner(model(), options(Mode::DEMO), numbered());
  // The agent is the second one of the message; row 0 means that its goal lies ahead.
  const PerceptionsBuilder scene = PerceptionsBuilder(3, 1).agent(9, goalIn(1, 2.0)).agent(4, goalIn(0, 2.0));
  const auto values = valuesOf(learner, scene, 4);
  ASSERT_TRUE(values);
  ASSERT_EQ(values->moves.size(), 8U);
  for (Action action = 0; action < 8; ++action) {
    const ValuedMove& valued = values->moves[action];
    EXPECT_EQ(valued.row, 0U);
    EXPECT_EQ(valued.value, 10.0 * action);
    EXPECT_EQ(valued.visits, 100 + action);
    EXPECT_EQ(valued.move.fraction, 1.0);
    EXPECT_NEAR(std::remainder(toDegrees(bearingOf(valued.move.direction)) - 45.0 * action, 360.0), 0.0, 1e-9);
  }
  EXPECT_EQ(values->chosen, 7U);
  EXPECT_FALSE(values->isExploration());
}

TEST(DecisionValues, AreThoseFromWhichTheAgentChoseWhileItLearns) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  // It came 1 m nearer with action 0: 0.5 (1 + 0.5 * 0), learned once.
  const auto values = valuesOf(learner, tick(1, 0, 3.0), 0);
  ASSERT_TRUE(values);
  EXPECT_EQ(values->moves[0].value, 0.5);
  EXPECT_EQ(values->moves[0].visits, 1U);
  EXPECT_EQ(values->moves[1].value, 0.0);
  EXPECT_EQ(values->moves[1].visits, 0U);
  EXPECT_EQ(values->chosen, 0U);
}

TEST(DecisionValues, TellExploration) {
  Learner::Options curious = options(Mode::TRAINING);
  curious.plan.epsilon = EpsilonSchedule::constant(1.0);
  curious.plan.parameters.alpha = 1e-9;  // the values hardly change
  Learner learner(model(), curious, numbered());
  int explorations = 0;
  for (std::uint64_t i = 0; i < 50; ++i) {
    const PerceptionsBuilder scene = tick(i, 0, 2.0);
    const RelativeActions answer = decide(learner, scene);
    const auto values = learner.valuesOf(scene.all(), answer, 0);
    ASSERT_TRUE(values);
    EXPECT_EQ(values->chosen, (actionOf(answer.agents.at(0)) + 8) % 8);
    EXPECT_EQ(values->isExploration(), values->chosen != 7);
    explorations += values->isExploration() ? 1 : 0;
  }
  EXPECT_GT(explorations, 25);
  EXPECT_LT(explorations, 50);
}

TEST(DecisionValues, AreAbsentIfTheAgentDidNotDecide) {
  Learner::Options some = options(Mode::DEMO);
  some.agents = {1, 2};
  Learner learner(model(), some);
  const PerceptionsBuilder scene = PerceptionsBuilder().agent(1, {1, 0}).agent(2, {0, 0}).arrived().agent(3, {1, 0});
  EXPECT_TRUE(valuesOf(learner, scene, 1));
  for (const AgentId agent : {2U, 3U, 77U}) EXPECT_FALSE(valuesOf(learner, scene, agent)) << agent;
}

}  // namespace
}  // namespace crowd::decision_values_test
