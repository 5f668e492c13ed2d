#include "learning/rl/q_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "common/random.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"

namespace crowd::q_table_test {
namespace {

/// The rows of a state set that has one row for all actions.
Rows sameRow(const Row& row) { return {&row, 0}; }

TEST(QTable, IsZeroAndUnvisitedAtFirst) {
  const QTable table(3, 2);
  EXPECT_EQ(table.rows(), 3U);
  EXPECT_EQ(table.actions(), 2U);
  for (Row row = 0; row < 3; ++row) {
    EXPECT_FALSE(table.isVisited(row));
    for (Action action = 0; action < 2; ++action) {
      EXPECT_EQ(table.value(row, action), 0.0);
      EXPECT_EQ(table.visits(row, action), 0U);
    }
  }
  EXPECT_EQ(table.visitedRows(), 0U);
}

TEST(QTable, RequiresARowAndAnAction) {
  EXPECT_THROW(QTable(0, 2), ShapeError);
  EXPECT_THROW(QTable(2, 0), ShapeError);
}

TEST(QTable, StoresEachEntrySeparately) {
  QTable table(3, 2);
  for (Row row = 0; row < 3; ++row) {
    for (Action action = 0; action < 2; ++action) table.set(row, action, row * 10.0 + action, row * 2 + action);
  }
  for (Row row = 0; row < 3; ++row) {
    for (Action action = 0; action < 2; ++action) {
      EXPECT_EQ(table.value(row, action), row * 10.0 + action);
      EXPECT_EQ(table.visits(row, action), row * 2 + action);
    }
  }
}

TEST(QTable, AddsToOneValueAndCountsOneVisit) {
  QTable table(2, 2);
  table.set(1, 0, 1.5, 7);
  table.addTo(1, 0, -2.0);
  table.countVisit(1, 0);
  EXPECT_EQ(table.value(1, 0), -0.5);
  EXPECT_EQ(table.visits(1, 0), 8U);
  EXPECT_EQ(table.value(1, 1), 0.0);
  EXPECT_EQ(table.visits(1, 1), 0U);
}

TEST(QTable, VisitsSaturate) {
  QTable table(1, 1);
  table.set(0, 0, 0.0, UINT32_MAX - 1);
  table.countVisit(0, 0);
  EXPECT_EQ(table.visits(0, 0), UINT32_MAX);
  table.countVisit(0, 0);
  EXPECT_EQ(table.visits(0, 0), UINT32_MAX);
}

TEST(QTable, RowIsVisitedIfAnyOfItsActionsIs) {
  QTable table(4, 3);
  table.countVisit(1, 2);
  table.countVisit(3, 0);
  table.countVisit(3, 1);
  table.set(0, 0, 5.0, 0);  // a value without visits
  EXPECT_FALSE(table.isVisited(0));
  EXPECT_TRUE(table.isVisited(1));
  EXPECT_FALSE(table.isVisited(2));
  EXPECT_TRUE(table.isVisited(3));
  EXPECT_EQ(table.visitedRows(), 2U);
}

/// The greedy action of a table of one row.
Action greedyOf(const std::vector<double>& values) {
  QTable table(2, static_cast<Action>(values.size()));
  for (Action action = 0; action < values.size(); ++action) table.set(1, action, values[action], 1);
  const Row row = 1;
  EXPECT_EQ(table.greedyValue(sameRow(row)), values[table.greedyAction(sameRow(row))]);
  return table.greedyAction(sameRow(row));
}

TEST(QTable, GreedyActionIsTheFirstWithTheHighestValue) {
  EXPECT_EQ(greedyOf({0.0, 0.0, 0.0}), 0U);
  EXPECT_EQ(greedyOf({1.0, 3.0, 2.0}), 1U);
  EXPECT_EQ(greedyOf({1.0, 2.0, 3.0}), 2U);
  EXPECT_EQ(greedyOf({1.0, 3.0, 3.0}), 1U);
  EXPECT_EQ(greedyOf({-5.0, -1.0, -1.0, -2.0}), 1U);
  EXPECT_EQ(greedyOf({-1e300, -std::numeric_limits<double>::max()}), 0U);
  EXPECT_EQ(greedyOf({-0.0, 0.0}), 0U);
}

/// The greedy action of a table of one row; a number in [0, 1) decides among equal values.
Action greedyOf(const std::vector<double>& values, double tie) {
  QTable table(2, static_cast<Action>(values.size()));
  for (Action action = 0; action < values.size(); ++action) table.set(1, action, values[action], 1);
  const Row row = 1;
  const std::vector<Row> rows(values.size(), row);
  EXPECT_EQ(table.greedyAction({rows.data(), 1}, tie), table.greedyAction(sameRow(row), tie));
  return table.greedyAction(sameRow(row), tie);
}

TEST(QTable, ANumberSelectsAmongEqualGreedyActions) {
  const double last = std::nextafter(1.0, 0.0);
  const std::vector<double> three = {2.0, 1.0, 2.0, -5.0, 2.0};  // actions 0, 2 and 4, for a third each
  EXPECT_EQ(greedyOf(three, 0.0), 0U);
  EXPECT_EQ(greedyOf(three, 0.33), 0U);
  EXPECT_EQ(greedyOf(three, 0.34), 2U);
  EXPECT_EQ(greedyOf(three, 0.66), 2U);
  EXPECT_EQ(greedyOf(three, 0.67), 4U);
  EXPECT_EQ(greedyOf(three, last), 4U);
  EXPECT_EQ(greedyOf({1.0, 3.0, 2.0}, last), 1U);  // one alone
  EXPECT_EQ(greedyOf({-0.0, 0.0}, 0.5), 1U);
  for (Action actions = 1; actions <= 40; ++actions) {
    EXPECT_EQ(greedyOf(std::vector<double>(actions, -1.0), last), actions - 1);
    EXPECT_EQ(greedyOf(std::vector<double>(actions, -1.0), 0.0), 0U);
  }
}

TEST(QTable, LooksUpEachActionInItsOwnRow) {
  // Actions 0, 1, 2 are in the situations 3, 0 and 3.
  const std::array<Row, 3> rows = {3, 0, 3};
  QTable table(4, 3);
  table.set(3, 0, 1.0, 1);
  table.set(0, 1, 2.0, 1);
  table.set(3, 2, 1.5, 1);
  table.set(3, 1, 9.0, 1);  // action 1 in situation 3: not requested
  table.set(0, 0, 9.0, 1);
  EXPECT_EQ(table.greedyAction({rows.data(), 1}), 1U);
  EXPECT_EQ(table.greedyValue({rows.data(), 1}), 2.0);
  table.set(0, 1, 1.0, 1);
  EXPECT_EQ(table.greedyAction({rows.data(), 1}), 2U);
  EXPECT_EQ(table.greedyValue({rows.data(), 1}), 1.5);
  table.set(3, 2, 1.0, 1);
  EXPECT_EQ(table.greedyAction({rows.data(), 1}), 0U);  // the first of equal values
}

TEST(QTable, FindsTheHighestValueAtAnyPosition) {
  const std::array<Row, 6> rows = {5, 1, 4, 0, 2, 3};
  for (Action actions = 1; actions <= 6; ++actions) {
    for (Action best = 0; best < actions; ++best) {
      QTable table(6, actions);
      for (Action action = 0; action < actions; ++action) {
        table.set(rows[action], action, action == best ? -1.0 : -2.0, 1);
      }
      EXPECT_EQ(table.greedyAction({rows.data(), 1}), best) << actions << " actions";
      EXPECT_EQ(table.greedyValue({rows.data(), 1}), -1.0) << actions << " actions, best " << best;
    }
  }
}

TEST(QTable, EqualityComparesEveryBit) {
  QTable a(2, 2);
  QTable b(2, 2);
  EXPECT_EQ(a, b);
  b.set(1, 1, 0.0, 1);
  EXPECT_NE(a, b);  // a visit more
  b.set(1, 1, -0.0, 0);
  EXPECT_NE(a, b);
  b.set(1, 1, std::numeric_limits<double>::denorm_min(), 0);
  EXPECT_NE(a, b);
  EXPECT_NE(QTable(2, 3), QTable(3, 2));
  EXPECT_NE(QTable(4, 1), QTable(2, 2));
}

TEST(QTable, CountsNewRows) {
  QTable table(4, 3);
  table.set(0, 1, 0.0, 5);
  EXPECT_EQ(table.newRows(), 0U);
  table.countVisit(0, 0);  // not new: another action has visits
  EXPECT_EQ(table.newRows(), 0U);
  table.countVisit(1, 2);
  table.countVisit(1, 2);
  table.countVisit(1, 0);
  EXPECT_EQ(table.newRows(), 1U);
  QTable copy = table;
  copy.countVisit(3, 1);
  EXPECT_EQ(copy.newRows(), 2U);
  EXPECT_EQ(table.newRows(), 1U);
}

}  // namespace
}  // namespace crowd::q_table_test
