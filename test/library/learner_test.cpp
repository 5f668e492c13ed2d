#include "social_crowd/learner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "learning/q_table_file.h"
#include "scenario/reading/scenario_files.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/episode_runner.h"
#include "social_crowd/episode.h"
#include "social_crowd/errors.h"
#include "support/learners.h"

namespace crowd::library::learner_test {
namespace {

/// A table in which the action that turns to the goal is the best one.
QTable towardsTheGoal() {
  TrainedTable trained{learners::model(), learners::options(Mode::DEMO).plan.parameters, 5, 1, learners::emptyTable()};
  for (const auto& [row, action] : {std::pair{0U, 0U}, {1U, 2U}, {2U, 4U}, {3U, 6U}}) {
    trained.table.set(row, static_cast<crowd::Action>(action), 1.0, 1);
  }
  return QTable(std::make_shared<TrainedTable>(std::move(trained)));
}

/// An agent alone with a goal.
Perceptions alone(const Vector2& goal, std::uint64_t tick = 0) {
  Perceptions perceptions;
  perceptions.tick = tick;
  Perception seen;
  seen.agent = 3;
  seen.max_speed = 1.0;
  seen.radius = 0.25;
  seen.goal = goal;
  seen.acted = tick > 0;
  perceptions.agents = {seen};
  return perceptions;
}

TEST(LibraryLearner, DecidesForTheAgentsOfAnotherSimulator) {
  Learner learner(towardsTheGoal());
  const double right_angle = std::acos(0.0);
  const std::vector<std::pair<Vector2, double>> cases = {
      {{3.0, 0.0}, 0.0}, {{0.0, 3.0}, right_angle}, {{0.0, -3.0}, -right_angle}};
  std::uint64_t tick = 0;
  for (const auto& [goal, rotation] : cases) {
    const std::vector<Action> actions = learner.decide(alone(goal, tick++));
    ASSERT_EQ(actions.size(), 1U);
    EXPECT_EQ(actions[0].agent, 3U);
    EXPECT_NEAR(std::remainder(actions[0].rotation - rotation, 4.0 * right_angle), 0.0, 1e-12);
    EXPECT_EQ(actions[0].speed_fraction, 1.0);
  }
}

TEST(LibraryLearner, DoesNotDecideAtTheEndOrForThoseThatHaveArrived) {
  Learner learner(towardsTheGoal());
  Perceptions perceptions = alone({3.0, 0.0});
  perceptions.agents[0].arrived = true;
  EXPECT_TRUE(learner.decide(perceptions).empty());
  perceptions.agents[0].arrived = false;
  perceptions.last = true;
  EXPECT_TRUE(learner.decide(perceptions).empty());
}

TEST(LibraryLearner, RefusesInvalidPerceptions) {
  Learner learner(towardsTheGoal());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(learner.decide(alone({nan, 0.0})), InputError);
  Perceptions perceptions = alone({3.0, 0.0});
  // The rim of the second one is nearer: at 1.5 m, after one at 1.9 m.
  perceptions.agents[0].neighbours = {{{2.0, 0.0}, {}, 0.1}, {{0.0, 2.0}, {}, 0.5}};
  EXPECT_THROW(learner.decide(perceptions), InputError);
  std::swap(perceptions.agents[0].neighbours[0], perceptions.agents[0].neighbours[1]);
  EXPECT_EQ(learner.decide(perceptions).size(), 1U);
  perceptions.agents[0].walls = {{{nan, 0.0}, {1.0, 0.0}}};
  EXPECT_THROW(learner.decide(perceptions), InputError);
}

/// Alpha and gamma are 0.5. The agent comes nearer to its goal by 0.25 m.
TEST(LibraryLearner, LearnsFromTheOutcomeOfItsDecisions) {
  const QTable before = towardsTheGoal();
  Learner learner(before);
  learner.decide(alone({3.0, 0.0}, 0));
  learner.decide(alone({2.75, 0.0}, 1));
  EXPECT_EQ(learner.table().value(0, 0), 1.0);  // it does not learn yet
  learner.startLearning(0.0);
  EXPECT_EQ(learner.decide(alone({2.5, 0.0}, 2)).size(), 1U);
  learner.decide(alone({2.25, 0.0}, 3));
  const QTable after = learner.table();
  // 1 + 0.5 * (0.25 + 0.5 * 1 - 1)
  EXPECT_NEAR(after.value(0, 0), 0.875, 1e-12);
  EXPECT_EQ(after.decisions(), 6U);
  EXPECT_EQ(before.value(0, 0), 1.0);
  learner.stopLearning();
  learner.decide(alone({2.0, 0.0}, 4));
  EXPECT_EQ(learner.table().value(0, 0), after.value(0, 0));
  EXPECT_THROW(learner.startLearning(1.5), InputError);
}

TEST(LibraryLearner, LearnsInAnEpisodeAsTheClassBehindIt) {
  const QTable begin = towardsTheGoal();
  Learner learner(begin, 9);
  learner.startLearning(0.25);
  Episode episode(Scenario::load("circle6"), begin.vision(), 9);
  while (episode.walk(learner)) {
  }
  crowd::Learner::Options options = learners::options(Mode::TRAINING);
  options.seed = 9;
  options.plan.parameters.epsilon = 0.25;
  options.plan.epsilon = EpsilonSchedule::constant(0.25);
  crowd::Learner expected(learners::model(), options, begin.trained().table);
  crowd::Episode same(readScenarios(findScenario("circle6")).scene(9, 0), 0, learners::model().vision());
  CrowdDecider decider(expected);
  runEpisode(same, decider);
  EXPECT_EQ(learner.table().trained().table, expected.tables().base());
  EXPECT_EQ(learner.table().decisions(), 5U + expected.decisions());
  EXPECT_GT(expected.decisions(), 100U);
}

}  // namespace
}  // namespace crowd::library::learner_test
