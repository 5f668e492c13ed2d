// Learning with mirrored updates. In learners::model(), rows 1 and 3 are mirror images, and so are actions a and 8 - a.

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "learning/q_table_file.h"
#include "support/error_of.h"
#include "support/learners.h"
#include "support/mirror_models.h"

namespace crowd::mirrored_learning_test {
namespace {

using learners::decide;
using learners::randomTick;
using mirror_models::mirrorOf;
using mirror_models::models;

constexpr LearningParameters HALVES = {0.5, 0.5, 0.0, 0.0};

TEST(MirroredLearning, UpdatesTheMirrorImageWithTheSameTarget) {
  const Mirror mirror = mirrorOf(learners::model());
  QTable table = learners::emptyTable();
  table.set(2, 5, 8.0, 1);
  table.set(3, 6, 4.0, 1);  // the mirror image has another value already
  const Row here = 1;
  const Row there = 2;
  TdLearner learner;
  learner.recordDecision(table, {&here, 0}, 2, HALVES);
  learner.learn(table, 2.0, {&there, 0}, HALVES, LearningRateSchedule(HALVES), mirror);  // target 2 + 0.5 * 8 = 6
  QTable expected = table;
  expected.set(1, 2, 3.0, 1);  // half of the way from 0
  expected.set(3, 6, 5.0, 2);  // half of the way from 4
  EXPECT_EQ(table, expected);
  learner.recordDecision(table, {&here, 0}, 0, HALVES);
  learner.learnTerminal(table, 16.0, HALVES, LearningRateSchedule(HALVES), mirror);
  expected.set(1, 0, 8.0, 1);
  expected.set(3, 0, 8.0, 1);
  EXPECT_EQ(table, expected);
}

TEST(MirroredLearning, UpdatesSymmetricEntriesOnce) {
  QTable table = learners::emptyTable();
  const Row ahead = 0;
  TdLearner learner;
  learner.recordDecision(table, {&ahead, 0}, 4, HALVES);
  learner.learnTerminal(table, 8.0, HALVES, LearningRateSchedule(HALVES), mirrorOf(learners::model()));
  QTable expected = learners::emptyTable();
  expected.set(0, 4, 4.0, 1);
  EXPECT_EQ(table, expected);
}

TEST(MirroredLearning, LearningRateOfTheMirrorImageDependsOnItsOwnVisits) {
  const LearningParameters means = {0.01, 0.5, 0.0, 0.0, 1.0};
  QTable table = learners::emptyTable();
  table.set(3, 7, 2.0, 3);
  const Row here = 1;
  TdLearner learner;
  learner.recordDecision(table, {&here, 0}, 1, means);
  learner.learnTerminal(table, 10.0, means, LearningRateSchedule(means), mirrorOf(learners::model()));
  EXPECT_EQ(table.value(1, 1), 10.0);  // the first visit
  EXPECT_EQ(table.value(3, 7), 4.0);   // the fourth: 2 + (10 - 2) / 4
  EXPECT_EQ(table.visits(3, 7), 4U);
}

TEST(MirroredLearning, AppliesTracesToMirrorImagesOfEarlierDecisions) {
  const LearningParameters traces = {0.5, 0.5, 0.5, 0.0};  // gamma * lambda = 0.25
  const Mirror mirror = mirrorOf(learners::model());
  QTable table = learners::emptyTable();
  table.set(2, 5, -8.0, 1);  // the mirror image of (2, 3)
  TdLearner learner;
  const auto decide_and_learn = [&](Row row, Action action, double reward, Row next) {
    learner.recordDecision(table, {&row, 0}, action, traces);
    learner.learn(table, reward, {&next, 0}, traces, LearningRateSchedule(traces), mirror);
  };
  decide_and_learn(1, 2, 8.0, 0);  // (1, 2) and (3, 6) become 4
  decide_and_learn(0, 0, 4.0, 2);  // its own image: step 2; a quarter of that goes back
  EXPECT_EQ(table.value(0, 0), 2.0);
  EXPECT_EQ(table.visits(0, 0), 1U);
  EXPECT_EQ(table.value(1, 2), 4.5);
  EXPECT_EQ(table.value(3, 6), 4.5);
  decide_and_learn(2, 3, 16.0, 5);  // steps 8, and 12 for the image, which was at -8; traces 0.25 and 0.0625
  EXPECT_EQ(table.value(2, 3), 8.0);
  EXPECT_EQ(table.value(2, 5), 4.0);
  EXPECT_EQ(table.value(0, 0), 4.0);  // once
  EXPECT_EQ(table.value(1, 2), 5.0);
  EXPECT_EQ(table.value(3, 6), 5.25);
}

/// Requires equal values of mirror images, bit for bit; counts the visited entries that are not their own image.
bool isSymmetric(const QTable& table, const Mirror& mirror, std::size_t& visited) {
  for (Row row = 0; row < table.rows(); ++row) {
    for (Action action = 0; action < table.actions(); ++action) {
      const Row image_row = mirror.row(row);
      const Action image_action = mirror.action(action);
      if (table.value(row, action) != table.value(image_row, image_action)) return false;
      if (table.visits(row, action) != table.visits(image_row, image_action)) return false;
      visited += table.visits(row, action) > 0 && (row != image_row || action != image_action) ? 1 : 0;
    }
  }
  return true;
}

QTable trainedTable(const Model& model, bool mirrored, double lambda) {
  Learner::Options options;
  options.mode = Mode::TRAINING;
  options.plan.parameters = {0.07, 0.9, lambda, 0.2, 0.6, mirrored};
  options.plan.epsilon = EpsilonSchedule::constant(0.2);
  Learner learner(model, options);
  for (std::uint64_t tick = 0; tick < 200; ++tick) decide(learner, randomTick(11, 0, tick, 6));
  return learner.tables().of(0);
}

TEST(MirroredLearning, KeepsATableSymmetricBitForBit) {
  for (const Model& model : models()) {
    SCOPED_TRACE(model.spec());
    const Mirror mirror = mirrorOf(model);
    for (const double lambda : {0.0, 0.7}) {
      std::size_t visited = 0;
      EXPECT_TRUE(isSymmetric(trainedTable(model, true, lambda), mirror, visited)) << "lambda " << lambda;
      EXPECT_GT(visited, 10U);
      EXPECT_FALSE(isSymmetric(trainedTable(model, false, lambda), mirror, visited)) << "lambda " << lambda;
    }
  }
}

TEST(MirroredLearning, FollowsChangesOfTheParameters) {
  Learner::Options options = learners::options(Mode::TRAINING);
  Learner learner(learners::model(), options);
  const auto gain_in_row_one = [&](std::uint64_t tick) {
    decide(learner, learners::tick(tick, 1, 4.0));
    decide(learner, learners::tick(tick + 1, 0, 3.0));
    learner.forgetDecisions();
  };
  LearningParameters parameters = options.plan.parameters;
  gain_in_row_one(0);
  EXPECT_FALSE(learner.tables().of(0).isVisited(3));
  parameters.mirrored = true;
  learner.setPlan({parameters, options.plan.epsilon});
  gain_in_row_one(10);
  EXPECT_EQ(learner.tables().of(0).visits(3, 0), 1U);
  EXPECT_EQ(learner.decisions(), 2U);  // mirrored updates are not counted as decisions
  parameters.mirrored = false;
  learner.setPlan({parameters, options.plan.epsilon});
  gain_in_row_one(20);
  EXPECT_EQ(learner.tables().of(0).visits(3, 0), 1U);
  EXPECT_EQ(learner.tables().of(0).visits(1, 0), 3U);
}

TEST(MirroredLearning, IsReadFromTheConfiguration) {
  const auto read = [](const std::string& yaml) { return readLearningPlan(YAML::Load(yaml), {"f", 0, "learning"}); };
  EXPECT_FALSE(read("{}").parameters.mirrored);
  EXPECT_FALSE(read("{mirrored: false}").parameters.mirrored);
  EXPECT_TRUE(read("{mirrored: true}").parameters.mirrored);
  EXPECT_TRUE(contains(errorOf<InputError>([&] { read("{mirrored: left}"); }), "learning.mirrored: expected"));
}

TEST(MirroredLearning, IsWrittenInTheHeaderOfTheTable) {
  TrainedTable trained = {learners::model(), HALVES, 1, 1, learners::randomTable(1)};
  EXPECT_FALSE(contains(toText(trained), "mirrored"));
  EXPECT_FALSE(parseQTable(toText(trained), "f").parameters.mirrored);
  trained.parameters.mirrored = true;
  EXPECT_TRUE(contains(toText(trained), "\nmirrored: true\n"));
  EXPECT_TRUE(parseQTable(toText(trained), "f").parameters.mirrored);
  EXPECT_EQ(toText(parseQTable(toText(trained), "f")), toText(trained));
}

}  // namespace
}  // namespace crowd::mirrored_learning_test
