#include "social_crowd/learning/rl/merge_copies.h"

#include <algorithm>

namespace crowd {
namespace {

using Copies = std::vector<const QTable*>;

void mergeEntry(const Copies& copies, const LearningRateSchedule& learning_rates, Row row, Action action,
                QTable& table) {
  const std::uint32_t before = table.visits(row, action);
  std::uint64_t since = 0;  // visits of all copies
  const QTable* only = nullptr;
  for (const QTable* copy : copies) {
    const std::uint32_t visits = copy->visits(row, action) - before;
    if (visits == 0) continue;
    only = since == 0 ? copy : nullptr;
    since += visits;
  }
  if (since == 0) return;
  if (only != nullptr) return table.set(row, action, only->value(row, action), only->visits(row, action));
  const auto after = static_cast<std::uint32_t>(std::min<std::uint64_t>(before + since, UINT32_MAX));
  const double past = table.value(row, action);
  double news = 0.0;  // weighted mean of the new experience, relative to the past value
  for (const QTable* copy : copies) {
    const std::uint32_t visits = copy->visits(row, action);
    if (visits == before) continue;
    const double weight = static_cast<double>(visits - before) / static_cast<double>(since);
    news += weight * (copy->value(row, action) - past) / (1.0 - learning_rates.retainedWeight(before, visits));
  }
  table.set(row, action, past + (1.0 - learning_rates.retainedWeight(before, after)) * news, after);
}

}  // namespace

void mergeCopies(const Copies& copies, const LearningRateSchedule& learning_rates, Row begin, Row end, QTable& table) {
  for (Row row = begin; row < end; ++row) {
    for (Action action = 0; action < table.actions(); ++action) mergeEntry(copies, learning_rates, row, action, table);
  }
}

}  // namespace crowd
