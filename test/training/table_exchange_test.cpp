// Merging of tables that learners on several ranks have learned in.

#include "training/table_exchange.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/random.h"
#include "learning/rl/merge_copies.h"
#include "support/seeds.h"
#include "support/thread_ranks.h"

namespace crowd::table_exchange_test {
namespace {

/// A learning rate of 0.5: each visit halves the weight of the value before.
LearningRateSchedule halves() {
  LearningParameters parameters;
  parameters.alpha = 0.5;
  return LearningRateSchedule(parameters);
}

/// Merges on ranks with blocks of the copies. Returns the table of each rank. @param blocks number of copies by rank
std::vector<QTable> mergeApart(const QTable& table, const std::vector<QTable>& copies,
                               const std::vector<std::size_t>& blocks, std::vector<std::uint64_t>& sent) {
  std::vector<QTable> merged(blocks.size(), table);
  sent.assign(blocks.size(), 0);
  ThreadRanks(static_cast<int>(blocks.size())).run([&](Communicator& communicator) {
    const auto rank = static_cast<std::size_t>(communicator.rank());
    std::size_t first = 0;
    for (std::size_t lower = 0; lower < rank; ++lower) first += blocks[lower];
    std::vector<const QTable*> own;
    for (std::size_t i = first; i < first + blocks[rank]; ++i) own.push_back(&copies[i]);
    ThreadPool thread_pool(1 + communicator.rank() % 2);
    mergeOnRanks(communicator, own, halves(), thread_pool, merged[rank]);
    sent[rank] = communicator.sentBytes();
  });
  return merged;
}

TEST(TableExchange, MergesNumbersThatWereWorkedOutByHand) {
  QTable table(5, 2);
  table.set(3, 1, 8.0, 2);
  table.set(2, 0, 1.0, 1);
  std::vector<QTable> copies(4, table);
  copies[0].set(3, 1, 4.0, 3);
  copies[2].set(3, 1, 12.0, 4);
  copies[3].set(4, 0, -1.5, 7);
  std::vector<std::uint64_t> sent;
  for (const QTable& merged : mergeApart(table, copies, {2, 1, 1}, sent)) {
    // A visit of -4 keeps 1/2 of the past, two of +4 keep 1/4: 1/3 (-4) / (1/2) + 2/3 (4) / (3/4) = 8/9 is the news,
    // of which three visits take 7/8.
    EXPECT_NEAR(merged.value(3, 1), 8.0 + 7.0 / 9.0, 1e-12);
    EXPECT_EQ(merged.visits(3, 1), 5U);
    EXPECT_EQ(merged.value(4, 0), -1.5) << "visited by one learner";
    EXPECT_EQ(merged.visits(4, 0), 7U);
    EXPECT_EQ(merged.value(2, 0), 1.0) << "not visited";
    EXPECT_EQ(merged.allVisits(), 5U + 7U + 1U);
  }
  // Sizes of the messages: 2 exchanges, 3 numbers of 8 bytes to 2 others. Row 3 is merged by rank 0 and row 4 by rank
  // 1; entries of 24 bytes go there, and from there to 2 others.
  EXPECT_EQ(sent, (std::vector<std::uint64_t>{96 + 2 * 24, 96 + 24 + 2 * 24, 96 + 24}));
}

TEST(TableExchange, AgreesWithOneProcessBitForBit) {
  forSeeds(60, KeyedRandom::CONTENT, [](std::uint64_t /*seed*/, KeyedRandom& random) {
    QTable table(1 + random.below(40), 1 + random.below(4));
    const auto learn = [&](QTable& copy, double share) {
      for (Row row = 0; row < table.rows(); ++row) {
        for (Action action = 0; action < table.actions(); ++action) {
          if (random.uniform() > share) continue;
          copy.set(row, action, random.uniform(-100.0, 100.0), copy.visits(row, action) + 1 + random.below(9));
        }
      }
    };
    learn(table, 0.5);
    std::vector<std::size_t> blocks(1 + random.below(5));
    std::vector<QTable> copies;
    for (std::size_t& block : blocks) {
      block = random.below(4);
      for (std::size_t i = 0; i < block; ++i) learn(copies.emplace_back(table), random.uniform());
    }
    std::vector<const QTable*> all;
    for (const QTable& copy : copies) all.push_back(&copy);
    QTable expected = table;
    mergeCopies(all, halves(), 0, table.rows(), expected);
    std::vector<std::uint64_t> sent;
    for (const QTable& merged : mergeApart(table, copies, blocks, sent)) EXPECT_EQ(merged, expected);
  });
}

TEST(TableExchange, VisitsSaturate) {
  QTable table(1, 1);
  table.set(0, 0, 2.0, UINT32_MAX - 3);
  std::vector<QTable> copies(2, table);
  copies[0].set(0, 0, 3.0, UINT32_MAX - 1);
  copies[1].set(0, 0, 3.0, UINT32_MAX);
  std::vector<std::uint64_t> sent;
  for (const QTable& merged : mergeApart(table, copies, {1, 1}, sent)) EXPECT_EQ(merged.visits(0, 0), UINT32_MAX);
}

}  // namespace
}  // namespace crowd::table_exchange_test
