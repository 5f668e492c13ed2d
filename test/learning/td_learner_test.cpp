#include "learning/rl/td_learner.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace crowd::td_learner_test {
namespace {

/// A learner on a table of a few rows and two actions, one row a state. All numbers are exact in binary.
class LearnerAndTable {
 public:
  explicit LearnerAndTable(double lambda) : parameters{0.5, 0.5, lambda, 0.0} {}

  void decide(Row row, Action action) { learner.recordDecision(table, {&row, 0}, action, parameters); }
  void learn(double reward, Row next) {
    learner.learn(table, reward, {&next, 0}, parameters, LearningRateSchedule(parameters));
  }
  void learnTerminal(double reward) {
    learner.learnTerminal(table, reward, parameters, LearningRateSchedule(parameters));
  }

  QTable table{4, 2};
  TdLearner learner;
  LearningParameters parameters;
};

// --- (3.1) without traces ---

TEST(QLearning, MovesAValueTowardsRewardAndBestNextValue) {
  LearnerAndTable both(0.0);
  both.table.set(1, 0, 4.0, 1);
  both.table.set(1, 1, 8.0, 1);
  both.decide(0, 1);
  both.learn(2.0, 1);  // target 2 + 0.5 * 8 = 6, half of the way from 0
  EXPECT_EQ(both.table.value(0, 1), 3.0);
  both.decide(1, 0);
  both.learn(-2.0, 0);  // target -2 + 0.5 * 3 = -0.5, from 4 down by half of 4.5
  EXPECT_EQ(both.table.value(1, 0), 1.75);
  both.decide(0, 1);
  both.learn(1.0, 0);  // target 1 + 0.5 * 3 = 2.5, from 3: its own value is the best of the next state
  EXPECT_EQ(both.table.value(0, 1), 2.75);
  EXPECT_EQ(both.table.value(0, 0), 0.0);
  EXPECT_EQ(both.table.value(1, 1), 8.0);
}

TEST(QLearning, UsesTheLearningRateOfTheThesis) {
  QTable table(2, 1);
  table.set(1, 0, 50.0, 1);
  TdLearner learner;
  const Row here = 0;
  const Row there = 1;
  const LearningParameters parameters;  // alpha 0.1, gamma 0.1, lambda 0
  learner.recordDecision(table, {&here, 0}, 0, parameters);
  learner.learn(table, 0.125, {&there, 0}, parameters, LearningRateSchedule(parameters));
  EXPECT_DOUBLE_EQ(table.value(0, 0), 0.5125);  // 0.1 * (0.125 + 0.1 * 50)
}

TEST(QLearning, LearningRateFallsWithVisitsToAlpha) {
  LearnerAndTable both(0.0);
  both.parameters.alpha = 0.25;
  both.parameters.alpha_decay = 1.0;  // steps 1, 1/2, 1/3, 1/4, 1/4: the mean of the rewards until then
  double expected[] = {6.0, 9.0, 8.0, 7.5, 5.625};
  double rewards[] = {6.0, 12.0, 6.0, 6.0, 0.0};
  for (int i = 0; i < 5; ++i) {
    both.decide(0, 1);
    both.learnTerminal(rewards[i]);
    EXPECT_DOUBLE_EQ(both.table.value(0, 1), expected[i]);
  }
}

TEST(QLearning, TerminalUpdateHasNoNextValue) {
  LearnerAndTable both(0.0);
  for (Row row = 0; row < 4; ++row) {
    for (Action action = 0; action < 2; ++action) both.table.set(row, action, 64.0, 1);
  }
  both.decide(2, 1);
  both.learnTerminal(100.0);
  EXPECT_EQ(both.table.value(2, 1), 82.0);  // 64 + 0.5 * (100 - 64): no best value is added
  EXPECT_FALSE(both.learner.hasDecision());
}

TEST(QLearning, UsesTheBestNextValueEvenIfNegative) {
  LearnerAndTable both(0.0);
  both.table.set(1, 0, -8.0, 1);
  both.table.set(1, 1, -4.0, 1);
  both.decide(0, 0);
  both.learn(0.0, 1);
  EXPECT_EQ(both.table.value(0, 0), -1.0);  // 0.5 * (0 + 0.5 * -4)
}

TEST(QLearning, WithoutTracesUpdatesOnlyTheLastDecision) {
  LearnerAndTable both(0.0);
  both.decide(0, 0);
  both.learn(8.0, 1);
  both.decide(1, 0);
  both.learn(8.0, 2);
  both.decide(2, 0);
  both.learnTerminal(8.0);
  for (Row row = 0; row < 3; ++row) EXPECT_EQ(both.table.value(row, 0), 4.0) << row;
}

TEST(QLearning, CountsOneVisitPerDecision) {
  for (const double lambda : {0.0, 0.5}) {
    LearnerAndTable both(lambda);
    both.decide(0, 0);
    both.learn(1.0, 0);
    both.decide(0, 0);
    both.learn(1.0, 1);
    both.decide(1, 1);
    both.learnTerminal(1.0);
    EXPECT_EQ(both.table.visits(0, 0), 2U);
    EXPECT_EQ(both.table.visits(0, 1), 0U);
    EXPECT_EQ(both.table.visits(1, 0), 0U);
    EXPECT_EQ(both.table.visits(1, 1), 1U);
    EXPECT_EQ(both.table.visitedRows(), 2U);
  }
}

TEST(QLearning, ReportsWhetherADecisionIsRecorded) {
  LearnerAndTable both(0.0);
  EXPECT_FALSE(both.learner.hasDecision());
  both.decide(0, 0);
  EXPECT_TRUE(both.learner.hasDecision());
  both.learner.resetTraces();
  EXPECT_FALSE(both.learner.hasDecision());
}

// --- Watkins's traces; alpha 0.5, gamma * lambda = 0.25 ---

TEST(WatkinsTraces, ApplyEachUpdateToEarlierDecisions) {
  LearnerAndTable both(0.5);
  both.decide(0, 0);
  both.learn(8.0, 1);  // error 8
  EXPECT_EQ(both.table.value(0, 0), 4.0);
  both.decide(1, 0);
  both.learn(4.0, 2);  // error 4; trace of (0, 0) 0.25
  EXPECT_EQ(both.table.value(1, 0), 2.0);
  EXPECT_EQ(both.table.value(0, 0), 4.5);  // 4 + 0.5 * 4 * 0.25
  both.decide(2, 0);
  both.learn(16.0, 0);  // error 16 + 0.5 * 4.5 = 18.25; traces 0.25 and 0.0625
  EXPECT_EQ(both.table.value(2, 0), 9.125);
  EXPECT_EQ(both.table.value(1, 0), 4.28125);    // 2 + 9.125 * 0.25
  EXPECT_EQ(both.table.value(0, 0), 5.0703125);  // 4.5 + 9.125 * 0.0625
}

TEST(WatkinsTraces, AreCutByAnExploratoryAction) {
  LearnerAndTable both(0.5);
  both.decide(0, 0);
  both.learn(8.0, 1);
  both.decide(1, 0);
  both.learn(4.0, 0);  // error 4 + 0.5 * 4 = 6: (1, 0) becomes 3, (0, 0) 4 + 3 * 0.25 = 4.75
  both.decide(0, 1);   // exploring: 0 against 4.75
  both.learn(2.0, 1);  // error 2 + 0.5 * 3 = 3.5
  EXPECT_EQ(both.table.value(0, 1), 1.75);
  EXPECT_EQ(both.table.value(0, 0), 4.75);
  EXPECT_EQ(both.table.value(1, 0), 3.0);
  // Later rewards are credited to the exploring action itself.
  both.decide(1, 0);
  both.learnTerminal(11.0);  // error 8; trace of (0, 1) 0.25, of (0, 0) none
  EXPECT_EQ(both.table.value(1, 0), 7.0);
  EXPECT_EQ(both.table.value(0, 1), 2.75);  // 1.75 + 4 * 0.25
  EXPECT_EQ(both.table.value(0, 0), 4.75);
}

TEST(WatkinsTraces, AreNotCutByAnActionOfEqualValue) {
  LearnerAndTable both(0.5);
  both.decide(0, 0);
  both.learn(8.0, 1);
  both.decide(1, 1);   // 0, as action 0
  both.learn(4.0, 2);  // error 4
  EXPECT_EQ(both.table.value(0, 0), 4.5);
}

TEST(WatkinsTraces, AccumulateForARepeatedDecision) {
  LearnerAndTable both(0.5);
  both.decide(0, 0);
  both.learn(8.0, 0);  // error 8 + 0.5 * 0
  EXPECT_EQ(both.table.value(0, 0), 4.0);
  both.decide(0, 0);
  both.learn(0.0, 1);                      // error 0 - 4; trace 0.25 + 1
  EXPECT_EQ(both.table.value(0, 0), 1.5);  // 4 - 0.5 * 4 * 1.25
}

TEST(WatkinsTraces, EndWithTheEpisode) {
  LearnerAndTable both(0.5);
  both.decide(0, 0);
  both.learnTerminal(8.0);
  both.decide(1, 0);
  both.learnTerminal(8.0);
  EXPECT_EQ(both.table.value(0, 0), 4.0);
  EXPECT_EQ(both.table.value(1, 0), 4.0);
}

TEST(WatkinsTraces, CanBeReset) {
  LearnerAndTable both(0.5);
  both.decide(0, 0);
  both.learn(8.0, 1);
  both.learner.resetTraces();
  EXPECT_EQ(both.table.value(0, 0), 4.0);  // the table stays
  both.decide(1, 0);
  both.learn(8.0, 2);
  EXPECT_EQ(both.table.value(0, 0), 4.0);
  EXPECT_EQ(both.table.value(1, 0), 4.0);
}

TEST(WatkinsTraces, AreClearedWhenLambdaBecomesZero) {
  LearnerAndTable both(0.5);
  both.decide(0, 0);
  both.learn(8.0, 1);
  both.parameters.lambda = 0.0;
  both.decide(1, 0);
  both.learn(8.0, 2);
  both.parameters.lambda = 0.5;
  both.decide(2, 0);
  both.learn(8.0, 3);
  EXPECT_EQ(both.table.value(0, 0), 4.0);
}

TEST(WatkinsTraces, ReachTheFirstDecisionOfALongEpisode) {
  // Lambda 1, gamma 0.5: a decision n steps back gets 0.5^n of the last step.
  QTable table(12, 1);
  TdLearner learner;
  const LearningParameters parameters = {1.0, 0.5, 1.0, 0.0};
  for (Row row = 0; row < 11; ++row) {
    learner.recordDecision(table, {&row, 0}, 0, parameters);
    const Row next = row + 1;
    if (row < 10) learner.learn(table, 0.0, {&next, 0}, parameters, LearningRateSchedule(parameters));
  }
  learner.learnTerminal(table, 1024.0, parameters, LearningRateSchedule(parameters));
  for (Row row = 0; row < 11; ++row) EXPECT_EQ(table.value(row, 0), 1 << row) << row;
}

// --- one row per action ---

TEST(QLearning, UpdatesTheRowOfTheChosenAction) {
  const std::array<Row, 2> here = {3, 1};
  const std::array<Row, 2> there = {2, 0};
  QTable table(4, 2);
  table.set(2, 0, 4.0, 1);
  table.set(0, 1, 6.0, 1);
  table.set(2, 1, 100.0, 1);  // not among the actions of the next state
  TdLearner learner;
  const LearningParameters parameters = {0.5, 0.5, 0.5, 0.0};
  learner.recordDecision(table, {here.data(), 1}, 1, parameters);
  learner.learn(table, 1.0, {there.data(), 1}, parameters, LearningRateSchedule(parameters));  // error 1 + 0.5 * 6 = 4
  EXPECT_EQ(table.value(1, 1), 2.0);
  EXPECT_EQ(table.visits(1, 1), 1U);
  EXPECT_FALSE(table.isVisited(3));
  // Action 0 is exploring (4 against 6): it cuts the trace.
  learner.recordDecision(table, {there.data(), 1}, 0, parameters);
  learner.learnTerminal(table, 0.0, parameters, LearningRateSchedule(parameters));
  EXPECT_EQ(table.value(2, 0), 2.0);
  EXPECT_EQ(table.value(1, 1), 2.0);
}

}  // namespace
}  // namespace crowd::td_learner_test
