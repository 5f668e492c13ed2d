#include "learning/rl/policy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crowd::policy_test {
namespace {

TEST(Policy, ChoosesTheFirstOfEqualValues) {
  const Row row = 0;
  QTable table(1, 4);
  EXPECT_EQ(chooseGreedy(table, {&row, 0}), 0U);
  table.set(0, 1, 2.0, 1);
  table.set(0, 3, 2.0, 1);
  EXPECT_EQ(chooseGreedy(table, {&row, 0}), 1U);
}

TEST(Policy, ExploresIfTheDrawIsBelowEpsilon) {
  const Row row = 0;
  QTable table(1, 4);
  table.set(0, 2, 1.0, 1);
  const auto choose = [&](double epsilon, double draw, double any) {
    return chooseEpsilonGreedy(table, {&row, 0}, epsilon, {draw, any});
  };
  EXPECT_EQ(choose(0.25, 0.25, 0.0), 2U);
  EXPECT_EQ(choose(0.25, std::nextafter(0.25, 0.0), 0.0), 0U);
  EXPECT_EQ(choose(0.0, 0.0, 0.0), 2U);
  EXPECT_EQ(choose(1.0, std::nextafter(1.0, 0.0), 0.0), 0U);
}

TEST(Policy, ExploresUniformly) {
  const Row row = 0;
  const QTable table(1, 4);
  const auto explore = [&](double any) { return chooseEpsilonGreedy(table, {&row, 0}, 1.0, {0.0, any}); };
  EXPECT_EQ(explore(0.0), 0U);
  EXPECT_EQ(explore(std::nextafter(0.25, 0.0)), 0U);
  EXPECT_EQ(explore(0.25), 1U);
  EXPECT_EQ(explore(0.5), 2U);
  EXPECT_EQ(explore(0.75), 3U);
  EXPECT_EQ(explore(std::nextafter(1.0, 0.0)), 3U);
}

}  // namespace
}  // namespace crowd::policy_test
