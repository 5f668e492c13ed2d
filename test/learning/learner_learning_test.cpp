// Updates of a learner in training mode, and cases in which nothing is learned.

#include <gtest/gtest.h>

#include "learning/learner.h"
#include "support/learners.h"

namespace crowd::learner_learning_test {
namespace {

using learners::actionOf;
using learners::decide;
using learners::decideOne;
using learners::emptyTable;
using learners::goalIn;
using learners::model;
using learners::options;
using learners::tick;

TEST(Learning, UpdatesTheValueOfTheLastDecision) {
  QTable table = emptyTable();
  table.set(1, 6, 8.0, 1);
  Learner learner(model(), options(Mode::TRAINING), table);
  EXPECT_EQ(decideOne(learner, tick(0, 0, 4.0)), 0U);
  EXPECT_EQ(learner.tables().of(0), table);
  EXPECT_EQ(decideOne(learner, tick(1, 1, 3.0)), 6U);  // 1 m gained; 1 + 0.5 * 8 = 5, half of it
  table.set(0, 0, 2.5, 1);
  EXPECT_EQ(learner.tables().of(0), table);
  EXPECT_EQ(learner.decisions(), 1U);
  decide(learner, tick(2, 0, 3.5));  // -0.5 + 0.5 * 2.5 = 0.75: from 8 down by half of 7.25
  table.set(1, 6, 4.375, 2);
  EXPECT_EQ(learner.tables().of(0), table);
  EXPECT_EQ(learner.decisions(), 2U);
}

TEST(Learning, SumsTheRewardsOfAnEpisode) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  EXPECT_EQ(learner.episodeReward(), 0.0);
  decide(learner, tick(1, 1, 3.0));
  decide(learner, tick(2, 0, 3.5));
  EXPECT_EQ(learner.episodeReward(), 0.5);  // 1 - 0.5
  decide(learner, tick(3, 0, 0.0).arrived());
  EXPECT_EQ(learner.episodeReward(), 100.5);
  decide(learner, PerceptionsBuilder(1, 0).agent(0, goalIn(0, 4.0)));
  EXPECT_EQ(learner.episodeReward(), 0.0);
}

TEST(Learning, IncludesTheCostOfObstacles) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  decide(learner, tick(1, 0, 4.0).neighbour({1.0, 0.0}, 0.25));  // class 2: -0.8, half of it
  EXPECT_DOUBLE_EQ(learner.tables().of(0).value(0, 0), -0.4);
  decide(learner, tick(2, 0, 4.0).neighbour({0.5, 0.0}, 0.25));  // class 1: -80; the row was 3 + 2
  EXPECT_DOUBLE_EQ(learner.tables().of(0).value(5, 0), -40.0);
}

TEST(Learning, IncludesTheRewardOfArrival) {
  QTable table = emptyTable();
  for (Row row = 0; row < table.rows(); ++row) table.set(row, 3, 64.0, 1);
  Learner learner(model(), options(Mode::TRAINING), table);
  decide(learner, tick(0, 2, 1.0));
  decide(learner, tick(1, 0, 0.0).arrived());
  table.set(2, 3, 82.0, 2);  // 64 + 0.5 * (100 - 64): no value of a next state
  EXPECT_EQ(learner.tables().of(0), table);
  EXPECT_EQ(learner.decisions(), 1U);
}

TEST(Learning, WithoutExplorationDecidesGreedilyAndLearns) {
  for (const Ties ties : {Ties::FIRST, Ties::RANDOM}) {
    Learner::Options training = options(Mode::TRAINING);
    training.plan.parameters.ties = ties;
    Learner::Options demo = training;
    demo.mode = Mode::DEMO;
    Learner learner(model(), training);
    for (std::uint64_t tick = 0; tick < 40; ++tick) {
      const QTable before = learner.tables().of(0);
      const PerceptionsBuilder scene = learners::randomTick(3, 0, tick, 12);
      const RelativeActions actions = decide(learner, scene);
      EXPECT_EQ(learner.tables().of(0) == before, tick == 0) << "tick " << tick;
      // All of them have learned, then all decide.
      Learner greedy(model(), demo, learner.tables().of(0));
      const RelativeActions expected = decide(greedy, scene);
      ASSERT_EQ(actions.agents.size(), 12U);
      for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(actionOf(actions.agents[i]), actionOf(expected.agents[i])) << "tick " << tick << ", agent " << i;
      }
    }
    EXPECT_GT(learner.decisions(), 300U);
  }
}

TEST(Learning, LearnsFromTheLastTick) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  decide(learner, tick(1, 0, 3.0).last());
  EXPECT_EQ(learner.tables().of(0).value(0, 0), 0.5);
  EXPECT_EQ(learner.decisions(), 1U);
}

TEST(Learning, LearnsOnceFromARepeatedTick) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  decide(learner, tick(1, 0, 3.0));
  decide(learner, tick(1, 0, 3.0));
  EXPECT_EQ(learner.decisions(), 1U);
  decide(learner, tick(2, 0, 2.0).last());
  const std::uint64_t decisions = learner.decisions();
  decide(learner, tick(2, 0, 2.0).last());
  EXPECT_EQ(learner.decisions(), decisions);
}

TEST(Learning, LearnsNothingFromAMissedAnswer) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  decide(learner, tick(1, 1, 3.0).missed());
  EXPECT_EQ(learner.tables().of(0), emptyTable());
  decide(learner, tick(2, 2, 1.0));  // but from the next: 2 m gained in row 1
  QTable expected = emptyTable();
  expected.set(1, 0, 1.0, 1);
  EXPECT_EQ(learner.tables().of(0), expected);
  EXPECT_EQ(learner.decisions(), 1U);
}

TEST(Learning, LearnsNothingAcrossAMissingTick) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  decide(learner, tick(2, 1, 3.0));  // tick 1 is missing
  decide(learner, tick(1, 2, 2.0));  // ticks do not descend
  decide(learner, PerceptionsBuilder(0, 2));
  decide(learner, tick(3, 3, 1.0));  // the agent was not there in tick 2
  EXPECT_EQ(learner.tables().of(0), emptyTable());
  EXPECT_EQ(learner.decisions(), 0U);
}

TEST(Learning, LearnsNothingAcrossEpisodes) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, PerceptionsBuilder(0, 0).agent(0, goalIn(0, 4.0)));
  decide(learner, PerceptionsBuilder(1, 1).agent(0, goalIn(1, 3.0)));
  decide(learner, PerceptionsBuilder(0, 2).agent(0, goalIn(2, 2.0)));
  EXPECT_EQ(learner.tables().of(0), emptyTable());
}

TEST(Learning, LearnsNothingAcrossAChangeOfMode) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, tick(0, 0, 4.0));
  learner.setMode(Mode::DEMO);
  learner.setMode(Mode::TRAINING);
  decide(learner, tick(1, 1, 3.0));
  EXPECT_EQ(learner.tables().of(0), emptyTable());
  learner.setMode(Mode::TRAINING);  // no change of mode: learning continues
  decide(learner, tick(2, 2, 2.0));
  EXPECT_EQ(learner.tables().of(0).value(1, 0), 0.5);
  learner.forgetDecisions();
  decide(learner, tick(3, 3, 1.0));
  EXPECT_EQ(learner.decisions(), 1U);
}

TEST(Learning, UpdatesAllAgentsBeforeDecisions) {
  Learner learner(model(), options(Mode::TRAINING));
  decide(learner, PerceptionsBuilder(0, 0).agent(0, goalIn(1, 4.0)).agent(1, goalIn(2, 3.0)));
  // Agent 1 comes last and found out that action 0 is bad in row 2; agent 0 comes first and is there now.
  const RelativeActions actions =
      decide(learner, PerceptionsBuilder(0, 1).agent(0, goalIn(2, 4.0)).agent(1, goalIn(2, 5.0)));
  EXPECT_EQ(actionOf(actions.agents.at(0)), 1U);
  EXPECT_EQ(actionOf(actions.agents.at(1)), 1U);
}

TEST(Learning, KeepsTracesOfEachAgentSeparate) {
  Learner::Options traces = options(Mode::TRAINING);
  traces.plan.parameters.lambda = 0.5;  // gamma * lambda = 0.25
  Learner learner(model(), traces);
  decide(learner, PerceptionsBuilder(0, 0).agent(0, goalIn(0, 8.0)).agent(1, goalIn(3, 8.0)));
  decide(learner, PerceptionsBuilder(0, 1).agent(0, goalIn(1, 8.0)).agent(1, goalIn(3, 8.0)));
  decide(learner, PerceptionsBuilder(0, 2).agent(0, goalIn(2, 4.0)).agent(1, goalIn(3, 8.0)));
  EXPECT_EQ(learner.tables().of(0).value(1, 0), 2.0);  // half of 4 m
  EXPECT_EQ(learner.tables().of(0).value(0, 0), 0.5);  // a quarter of that
  EXPECT_EQ(learner.tables().of(0).value(3, 0), 0.0);  // the other agent gained nothing
}

TEST(Learning, AMissedAnswerCutsTraces) {
  Learner::Options traces = options(Mode::TRAINING);
  traces.plan.parameters.lambda = 0.5;
  Learner learner(model(), traces);
  decide(learner, tick(0, 0, 8.0));
  decide(learner, tick(1, 1, 8.0));
  decide(learner, tick(2, 2, 8.0).missed());
  decide(learner, tick(3, 3, 4.0));
  EXPECT_EQ(learner.tables().of(0).value(2, 0), 2.0);
  EXPECT_EQ(learner.tables().of(0).value(0, 0), 0.0);
}

}  // namespace
}  // namespace crowd::learner_learning_test
