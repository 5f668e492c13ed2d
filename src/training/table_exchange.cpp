#include "training/table_exchange.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <tuple>

#include "learning/rl/merge_copies.h"
#include "social_crowd/errors.h"

namespace crowd {
namespace {

using Bytes = Communicator::Bytes;

/// A value on its way to another rank: 24 bytes.
struct ExchangedEntry {
  double value = 0.0;
  Row row = 0;
  std::uint32_t visits = 0;
  Action action = 0;
  std::uint32_t unused = 0;  // no byte of a message is undefined
};

void append(const ExchangedEntry& entry, Bytes& bytes) {
  const std::size_t end = bytes.size();
  bytes.resize(end + sizeof(ExchangedEntry));
  std::memcpy(bytes.data() + end, &entry, sizeof(ExchangedEntry));
}

/// The entries of a message.
std::vector<ExchangedEntry> entriesOf(const Bytes& bytes) {
  if (bytes.size() % sizeof(ExchangedEntry) != 0) throw Error("a message between ranks is too short");
  std::vector<ExchangedEntry> entries(bytes.size() / sizeof(ExchangedEntry));
  if (!entries.empty()) std::memcpy(entries.data(), bytes.data(), bytes.size());
  return entries;
}

/// Returns what a copy has learned, for each rank the values of the rows that it merges. Rows that are visited often
/// lie together, so that neighbouring rows go to different ranks.
std::vector<Bytes> learnedBy(const QTable& copy, const QTable& table, std::size_t ranks) {
  std::vector<Bytes> out(ranks);
  for (Row row = 0; row < table.rows(); ++row) {
    for (Action action = 0; action < table.actions(); ++action) {
      const std::uint32_t visits = copy.visits(row, action);
      if (visits != table.visits(row, action))
        append({copy.value(row, action), row, visits, action, 0}, out[row % ranks]);
    }
  }
  return out;
}

/// Merges the values of all learners, in their order, into the table. Returns the merged values.
Bytes mergeEntries(const std::vector<Bytes>& learned, const LearningRateSchedule& learning_rates, QTable& table) {
  std::vector<ExchangedEntry> entries;
  for (const Bytes& bytes : learned) {
    const std::vector<ExchangedEntry> more = entriesOf(bytes);
    entries.insert(entries.end(), more.begin(), more.end());
  }
  const auto place = [](const ExchangedEntry& entry) { return std::tie(entry.row, entry.action); };
  // Stable: the values of each place stay in the order of the learners.
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const ExchangedEntry& a, const ExchangedEntry& b) { return place(a) < place(b); });
  Bytes merged;
  std::vector<LearnedValue> values;
  for (auto next = entries.begin(); next != entries.end();) {
    const auto [row, action] = std::tuple<Row, Action>(place(*next));
    values.clear();
    for (; next != entries.end() && place(*next) == std::tie(row, action); ++next) {
      values.push_back({next->value, next->visits});
    }
    mergeValue(values, learning_rates, row, action, table);
    append({table.value(row, action), row, table.visits(row, action), action, 0}, merged);
  }
  return merged;
}

}  // namespace

void mergeOnRanks(Communicator& communicator, const std::vector<const QTable*>& copies,
                  const LearningRateSchedule& learning_rates, ThreadPool& thread_pool, QTable& table) {
  const auto ranks = static_cast<std::size_t>(communicator.size());
  const auto own = static_cast<std::size_t>(communicator.rank());
  std::vector<std::vector<Bytes>> learned(copies.size());
  thread_pool.run(copies.size(), [&](unsigned /*worker*/, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) learned[i] = learnedBy(*copies[i], table, ranks);
  });
  std::vector<Bytes> out(ranks);
  for (const std::vector<Bytes>& by_rank : learned) {
    for (std::size_t rank = 0; rank < ranks; ++rank) {
      out[rank].insert(out[rank].end(), by_rank[rank].begin(), by_rank[rank].end());
    }
  }
  learned.clear();
  Bytes kept;  // what this rank merges itself
  std::swap(kept, out[own]);
  std::vector<Bytes> in;
  communicator.exchangeAnySize(out, in);
  std::swap(in[own], kept);
  const Bytes merged = mergeEntries(in, learning_rates, table);
  out.assign(ranks, merged);
  out[own].clear();
  communicator.exchangeAnySize(out, in);
  for (const Bytes& bytes : in) {
    for (const ExchangedEntry& entry : entriesOf(bytes)) table.set(entry.row, entry.action, entry.value, entry.visits);
  }
}

}  // namespace crowd
