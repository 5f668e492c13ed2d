#include "learning/rl/merge_copies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/random.h"
#include "learning/rl/td_learner.h"

namespace crowd::merge_copies_test {
namespace {

/// Updates the only entry of the table with a target.
void learnOne(QTable& table, double target, const LearningParameters& parameters) {
  const Row row = 0;
  TdLearner learner;
  learner.recordDecision(table, {&row, 0}, 0, parameters);
  learner.learnTerminal(table, target, parameters, LearningRateSchedule(parameters));
}

QTable learned(QTable table, const std::vector<double>& targets, const LearningParameters& parameters) {
  for (const double target : targets) learnOne(table, target, parameters);
  return table;
}

QTable merged(QTable table, const std::vector<QTable>& copies, const LearningParameters& parameters) {
  std::vector<const QTable*> pointers;
  pointers.reserve(copies.size());
  for (const QTable& copy : copies) pointers.push_back(&copy);
  mergeCopies(pointers, LearningRateSchedule(parameters), 0, table.rows(), table);
  return table;
}

QTable tableOf(double value, std::uint32_t visits) {
  QTable table(1, 1);
  table.set(0, 0, value, visits);
  return table;
}

constexpr LearningParameters MEANS = {1e-6, 0.5, 0.0, 0.0, 1.0};  // a value is the mean of its targets
constexpr LearningParameters HALVES = {0.5, 0.5, 0.0, 0.0, 0.0};

TEST(RetainedWeight, IsTheProductOfOneMinusEachLearningRate) {
  EXPECT_EQ(LearningRateSchedule(HALVES).retainedWeight(7, 7), 1.0);
  EXPECT_EQ(LearningRateSchedule(HALVES).retainedWeight(7, 10), 0.125);
  EXPECT_DOUBLE_EQ(LearningRateSchedule(MEANS).retainedWeight(2, 6), 2.0 / 6.0);  // 2/3 * 3/4 * 4/5 * 5/6
  EXPECT_EQ(LearningRateSchedule(MEANS).retainedWeight(0, 3), 0.0);               // the first learning rate is 1
  const LearningParameters quarter = {0.25, 0.5, 0.0, 0.0, 1.0};
  EXPECT_DOUBLE_EQ(LearningRateSchedule(quarter).retainedWeight(1, 6),
                   1.0 / 2 * 2 / 3 * 3 / 4 * 3 / 4 * 3 / 4);  // steps 1/2, 1/3, then 1/4
}

TEST(MergeCopies, MeansIncludeCommonVisitsOnce) {
  const QTable past = learned(tableOf(0.0, 0), {1.0, 3.0, 0.0, 4.0}, MEANS);
  EXPECT_DOUBLE_EQ(past.value(0, 0), 2.0);
  const QTable one = learned(past, {6.0, 6.0}, MEANS);
  const QTable other = learned(past, {10.0}, MEANS);
  const QTable all = merged(past, {one, other}, MEANS);
  EXPECT_DOUBLE_EQ(all.value(0, 0), 30.0 / 7.0);  // (1 + 3 + 0 + 4 + 6 + 6 + 10) / 7
  EXPECT_EQ(all.visits(0, 0), 7U);
}

TEST(MergeCopies, ConstantRatesForgetOldValuesAsOneLearnerDoes) {
  const QTable past = tableOf(8.0, 100);
  // Both learned 0 with rate 1/2; one learner would get 8 -> 4 -> 2.
  const QTable same = merged(past, {learned(past, {0.0}, HALVES), learned(past, {0.0}, HALVES)}, HALVES);
  EXPECT_EQ(same.value(0, 0), 2.0);
  EXPECT_EQ(same.visits(0, 0), 102U);
  // One learned 0 twice (8 -> 4 -> 2), the other 24 once (8 -> 16): the old value keeps the weight 1/8; the mean of the
  // targets is (0 + 0 + 24) / 3.
  const QTable different = merged(past, {learned(past, {0.0, 0.0}, HALVES), learned(past, {24.0}, HALVES)}, HALVES);
  EXPECT_DOUBLE_EQ(different.value(0, 0), 8.0);
  EXPECT_EQ(different.visits(0, 0), 103U);
}

TEST(MergeCopies, EqualTargetsGiveTheValueOfOneLearner) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    LearningParameters parameters = HALVES;
    parameters.alpha = random.uniform(0.001, 1.0);
    parameters.alpha_decay = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 1.0);
    const double before = random.uniform(-10.0, 10.0);
    const double target = random.uniform(-10.0, 10.0);
    const QTable past = tableOf(before, random.below(50));
    std::vector<QTable> copies;
    std::vector<double> all;
    for (std::uint32_t left = 1 + random.below(5); left > 0; --left) {
      const std::vector<double> targets(random.below(40), target);
      copies.push_back(learned(past, targets, parameters));
      all.insert(all.end(), targets.begin(), targets.end());
    }
    const QTable got = merged(past, copies, parameters);
    const QTable expected = learned(past, all, parameters);
    ASSERT_NEAR(got.value(0, 0), expected.value(0, 0), 1e-10) << "seed " << seed;
    ASSERT_EQ(got.visits(0, 0), expected.visits(0, 0)) << "seed " << seed;
  }
}

TEST(MergeCopies, StaysInTheRangeOfOldValueAndTargets) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const LearningParameters parameters = {0.05, 0.5, 0.0, 0.0, random.uniform(0.0, 1.0)};
    const double before = random.uniform(-1.0, 1.0);
    const QTable past = tableOf(before, 1 + random.below(1000));
    std::vector<QTable> copies;
    for (std::uint32_t left = 8; left > 0; --left) {
      std::vector<double> targets(random.below(60));
      for (double& target : targets) target = random.uniform(-1.0, 1.0);
      copies.push_back(learned(past, targets, parameters));
    }
    ASSERT_LE(std::abs(merged(past, copies, parameters).value(0, 0)), 1.0) << "seed " << seed;
  }
}

TEST(MergeCopies, TakesOverTheOnlyChangedCopyBitForBit) {
  const QTable past = tableOf(0.1, 3);
  const QTable one = learned(past, {0.3, 0.7}, {0.1, 0.5, 0.0, 0.0, 0.6});
  EXPECT_EQ(merged(past, {past, one, past}, {0.1, 0.5, 0.0, 0.0, 0.6}), one);
}

TEST(MergeCopies, UnchangedCopiesChangeNothing) {
  const QTable past = tableOf(0.1, 3);
  EXPECT_EQ(merged(past, {past, past, past, past}, MEANS), past);
}

TEST(MergeCopies, VisitsSaturate) {
  const QTable past = tableOf(8.0, UINT32_MAX - 1);
  const QTable copy = learned(past, {0.0}, HALVES);
  EXPECT_EQ(merged(past, {copy, copy, copy}, HALVES).visits(0, 0), UINT32_MAX);
}

TEST(MergeCopies, MergesOnlyTheRequestedRows) {
  QTable table(3, 2);
  QTable copy = table;
  for (Row row = 0; row < 3; ++row) copy.set(row, 1, 5.0, 2);
  QTable expected = table;
  expected.set(1, 1, 5.0, 2);
  const QTable idle = table;
  mergeCopies({&copy, &idle}, LearningRateSchedule(HALVES), 1, 2, table);
  EXPECT_EQ(table, expected);
}

}  // namespace
}  // namespace crowd::merge_copies_test
