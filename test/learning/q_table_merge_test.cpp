#include "learning/rl/q_table.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "common/random.h"
#include "social_crowd/errors.h"
#include "support/error_of.h"

namespace crowd::q_table_merge_test {
namespace {

QTable cell(double value, std::uint32_t visits) {
  QTable table(1, 1);
  table.set(0, 0, value, visits);
  return table;
}

void expectMerged(const QTable& into, const QTable& from, double value, std::uint32_t visits) {
  QTable merged = into;
  merged.merge(from);
  EXPECT_DOUBLE_EQ(merged.value(0, 0), value);
  EXPECT_EQ(merged.visits(0, 0), visits);
}

TEST(QTableMerge, IsTheMeanWeightedByVisits) {
  expectMerged(cell(2.0, 3), cell(6.0, 1), 3.0, 4);  // (3 * 2 + 1 * 6) / 4
  expectMerged(cell(-1.0, 1), cell(3.0, 1), 1.0, 2);
  expectMerged(cell(10.0, 1), cell(0.0, 9), 1.0, 10);  // a visited zero counts
}

TEST(QTableMerge, TakesOverEntriesVisitedInOneTableOnly) {
  expectMerged(cell(0.0, 0), cell(0.1, 5), 0.1, 5);
  expectMerged(cell(0.1, 5), cell(0.0, 0), 0.1, 5);
  expectMerged(cell(7.0, 0), cell(0.1, 5), 0.1, 5);  // a value without visits has no weight
  expectMerged(cell(0.1, 5), cell(7.0, 0), 0.1, 5);
  expectMerged(cell(7.0, 0), cell(8.0, 0), 7.0, 0);  // neither was visited: the value stays
}

TEST(QTableMerge, VisitsSaturateButKeepTheirWeight) {
  expectMerged(cell(1.0, UINT32_MAX), cell(3.0, UINT32_MAX), 2.0, UINT32_MAX);
  expectMerged(cell(0.0, UINT32_MAX), cell(4.0, 1431655765), 1.0, UINT32_MAX);  // a third of it: 1/4 of the sum
}

TEST(QTableMerge, StaysInTheRangeOfBothValues) {
  expectMerged(cell(-1.5e308, 1), cell(1.5e308, 1), 0.0, 2);
  expectMerged(cell(-1.5e308, 0), cell(1.5e308, 1), 1.5e308, 1);
}

TEST(QTableMerge, KeepsEqualValues) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    const double value = random.uniform(-100.0, 100.0);
    QTable table = cell(value, 1 + random.below(9));
    table.merge(cell(value, 1 + random.below(9)));
    EXPECT_EQ(table.value(0, 0), value);  // bit for bit: merging known experience changes nothing
  }
}

TEST(QTableMerge, MergesEachEntrySeparately) {
  QTable a(2, 2);
  a.set(0, 0, 1.0, 1);
  a.set(0, 1, 2.0, 1);
  QTable b(2, 2);
  b.set(0, 1, 4.0, 3);
  b.set(1, 0, -3.0, 2);
  a.merge(b);
  QTable expected(2, 2);
  expected.set(0, 0, 1.0, 1);
  expected.set(0, 1, 3.5, 4);  // (2 + 3 * 4) / 4
  expected.set(1, 0, -3.0, 2);
  EXPECT_EQ(a, expected);
}

TEST(QTableMerge, GivesTheMeanOfAllVisitsInBothDirections) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    KeyedRandom random(seed, KeyedRandom::PLACEMENT, {});
    QTable a(5, 4);
    QTable b(5, 4);
    for (Row row = 0; row < 5; ++row) {
      for (Action action = 0; action < 4; ++action) {
        const std::uint32_t visits = random.below(4);
        a.set(row, action, visits > 0 ? random.uniform(-100.0, 100.0) : 0.0, visits);
        const std::uint32_t others = random.below(4);
        b.set(row, action, others > 0 ? random.uniform(-100.0, 100.0) : 0.0, others);
      }
    }
    QTable ab = a;
    ab.merge(b);
    QTable ba = b;
    ba.merge(a);
    for (Row row = 0; row < 5; ++row) {
      for (Action action = 0; action < 4; ++action) {
        const double weight = a.visits(row, action) + b.visits(row, action);
        const double total =
            a.visits(row, action) * a.value(row, action) + b.visits(row, action) * b.value(row, action);
        EXPECT_EQ(ab.visits(row, action), weight);
        EXPECT_NEAR(ab.value(row, action), weight > 0.0 ? total / weight : 0.0, 1e-12);
        EXPECT_EQ(ba.visits(row, action), weight);
        EXPECT_NEAR(ba.value(row, action), ab.value(row, action), 1e-12);
      }
    }
  }
}

/// A table of one row and action whose visits belong to a named source.
QTable sourced(SourceId source, double value, std::uint32_t visits) {
  QTable table = cell(value, visits);
  table.nameSource(source);
  return table;
}

/// The same table after more visits of another named source.
QTable wentOn(QTable table, SourceId source, double value, std::uint32_t visits) {
  table.beginSource();
  table.set(0, 0, value, table.visits(0, 0) + visits);
  table.nameSource(source);
  return table;
}

TEST(QTableMerge, CountsCommonVisitsOnce) {
  const QTable past = sourced(1, 2.0, 100);
  // Two tables learned on from it: 3 and 1 visits that the other does not have.
  const QTable a = wentOn(past, 2, 4.0, 3);
  const QTable b = wentOn(past, 3, 8.0, 1);
  expectMerged(a, b, 5.0, 104);  // (3 * 4 + 1 * 8) / 4
  expectMerged(b, a, 5.0, 104);
  expectMerged(past, a, 4.0, 103);  // it has no visits that the other lacks
  expectMerged(a, past, 4.0, 103);
}

TEST(QTableMerge, RepeatedMergeChangesNothing) {
  QTable table = wentOn(sourced(1, 0.3, 100), 2, 0.1, 7);
  const QTable other = wentOn(sourced(3, 0.7, 11), 4, -0.2, 5);
  EXPECT_EQ(table.newVisitsOf(other), 16U);
  EXPECT_EQ(table.merge(other), 16U);
  const QTable merged = table;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(table.newVisitsOf(other), 0U);
    EXPECT_EQ(table.merge(other), 0U);
    EXPECT_EQ(table, merged);
  }
  EXPECT_EQ(table.foreign().size(), 3U);
}

TEST(QTableMerge, MergesALaterStateOfASource) {
  QTable learner = sourced(1, 1.0, 10);
  QTable receiver = cell(3.0, 10);
  EXPECT_EQ(receiver.merge(learner), 10U);  // (10 * 3 + 10 * 1) / 2 = 2
  learner.set(0, 0, 6.0, 15);
  EXPECT_EQ(receiver.merge(learner), 5U);
  EXPECT_EQ(receiver.visits(0, 0), 25U);
  EXPECT_DOUBLE_EQ(receiver.value(0, 0), (10 * 2.0 + 5 * 6.0) / 15);  // 10 visits are only here, 5 only there
  EXPECT_EQ(learner.merge(receiver), 10U);                            // what the receiver learned itself
  EXPECT_EQ(learner.visits(0, 0), 25U);
}

TEST(QTableMerge, RecognisesAFileOfTheSameContent) {
  const QTable file = cell(2.0, 100);
  QTable a = file;
  a.beginSource();
  QTable b = file;
  b.beginSource();
  EXPECT_EQ(a.merge(b), 0U);
  EXPECT_EQ(a, file);
  QTable other = cell(2.5, 100);  // with different content
  EXPECT_EQ(a.newVisitsOf(other), 100U);
  // The name is that of the content that was read, also after changes.
  EXPECT_EQ(other.merge(file), 100U);
  EXPECT_EQ(other.merge(file), 0U);
  EXPECT_EQ(other.merge(cell(2.5, 100)), 0U);
  EXPECT_EQ(other.visits(0, 0), 200U);
}

TEST(QTableMerge, VisitsDoNotDependOnTheOrder) {
  const QTable past = sourced(1, 0.0, 5);
  const std::array<QTable, 3> tables = {wentOn(past, 2, 1.0, 1), wentOn(past, 3, 2.0, 20), wentOn(past, 4, 3.0, 300)};
  for (const auto& order : {std::array<int, 3>{0, 1, 2}, {2, 1, 0}, {1, 2, 0}, {1, 0, 2}}) {
    QTable merged = tables[order[0]];
    merged.merge(tables[order[1]]);
    merged.merge(tables[order[2]]);
    EXPECT_EQ(merged.visits(0, 0), 326U);
  }
}

TEST(QTableMerge, SharesTheMemoryOfContributions) {
  QTable a = sourced(1, 1.0, 10);
  const QTable b = sourced(2, 2.0, 10);
  QTable c = wentOn(b, 3, 2.0, 1);
  a.merge(c);
  ASSERT_EQ(a.foreign().size(), 2U);
  EXPECT_EQ(a.foreign()[0].source, 2U);
  EXPECT_EQ(a.foreign()[0].visits, c.foreign()[0].visits);  // shared memory
  const Contributions before = a.foreign();
  a.merge(b);
  EXPECT_EQ(a.foreign()[0].visits, before[0].visits);
}

TEST(QTableMerge, SaturatedVisitsStayValid) {
  QTable a = sourced(1, 1.0, UINT32_MAX - 5);
  const QTable b = wentOn(sourced(2, 2.0, UINT32_MAX), 3, 2.0, 0);
  a.merge(b);
  EXPECT_EQ(a.visits(0, 0), UINT32_MAX);
  a.countVisit(0, 0);
  const QTable merged = a;
  a.merge(b);
  EXPECT_EQ(a, merged);
  // A table with more visits of the own source than the saturated sum allows brings no news.
  QTable receiver = sourced(1, 1.0, UINT32_MAX - 5);
  receiver.beginSource();
  EXPECT_EQ(a.merge(receiver), 0U);
  EXPECT_EQ(a, merged);
  EXPECT_EQ(receiver.merge(a), UINT32_MAX);
  EXPECT_EQ(receiver.merge(a), 0U);
}

TEST(QTableMerge, TakesTheLargerOfContradictoryVisits) {
  // Two tables with visits of source 1, of which neither includes the other.
  const auto claiming = [](Row row, std::uint32_t visits) {
    QTable table(3, 1);
    table.set(row, 0, 1.0, visits);
    table.nameSource(1);
    table.beginSource();
    return table;
  };
  QTable table = claiming(0, 4);
  EXPECT_EQ(table.merge(claiming(2, 3)), 3U);
  EXPECT_EQ(table.merge(claiming(2, 3)), 0U);
  EXPECT_EQ(table.merge(claiming(0, 4)), 0U);
  EXPECT_EQ(table.allVisits(), 7U);
  EXPECT_EQ(table.foreign().size(), 1U);
  EXPECT_FALSE(table.hasOwnVisits());
}

TEST(QTableSource, HasANameOnlyIfThereAreVisits) {
  QTable table(2, 2);
  EXPECT_EQ(table.source(), NO_SOURCE);
  table.nameSource(7);
  EXPECT_FALSE(table.isNamed());
  table.set(0, 1, 0.5, 3);
  EXPECT_EQ(table.source(), table.contentId());
  table.nameSource(7);
  EXPECT_EQ(table.source(), 7U);
  table.nameSource(8);  // it has one
  EXPECT_EQ(table.source(), 7U);
  table.beginSource();
  EXPECT_EQ(table.source(), NO_SOURCE);
  ASSERT_EQ(table.contributions().size(), 1U);
  EXPECT_EQ(table.contributions()[0].source, 7U);
  EXPECT_EQ(table.contributions()[0].visits->rows(), std::vector<Row>{0});
  table.countVisit(1, 1);
  table.nameSource(5);
  const Contributions both = table.contributions();
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0].source, 5U);
  EXPECT_EQ(both[0].visits->at(0)[1], 1U);
}

TEST(QTableSource, ChecksumDependsOnTheContent) {
  const QTable table = cell(0.5, 3);
  EXPECT_EQ(table.contentId(), cell(0.5, 3).contentId());
  EXPECT_NE(table.contentId(), cell(0.5, 4).contentId());
  EXPECT_NE(table.contentId(), cell(std::nextafter(0.5, 1.0), 3).contentId());
  EXPECT_NE(QTable(2, 1).contentId(), QTable(1, 2).contentId());
}

TEST(QTableMerge, RefusesAnotherShapeAndChangesNothing) {
  QTable table(2, 3);
  table.set(1, 2, 5.0, 1);
  const QTable before = table;
  for (const QTable& other : {QTable(3, 2), QTable(2, 2), QTable(3, 3), QTable(6, 1)}) {
    const std::string message = errorOf<ShapeError>([&] { table.merge(other); });
    EXPECT_TRUE(contains(message, "2 rows of 3 actions")) << message;
    EXPECT_EQ(table, before);
  }
}

}  // namespace
}  // namespace crowd::q_table_merge_test
