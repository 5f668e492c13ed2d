#include "learning/rl/merge_copies.h"

#include <algorithm>

namespace crowd {

void mergeValue(const std::vector<LearnedValue>& learned, const LearningRateSchedule& learning_rates, Row row,
                Action action, QTable& table) {
  if (learned.size() == 1) return table.set(row, action, learned.front().value, learned.front().visits);
  const std::uint32_t before = table.visits(row, action);
  std::uint64_t since = 0;  // visits of all copies
  for (const LearnedValue& copy : learned) since += copy.visits - before;
  const auto after = static_cast<std::uint32_t>(std::min<std::uint64_t>(before + since, UINT32_MAX));
  const double past = table.value(row, action);
  double news = 0.0;  // weighted mean of the new experience, relative to the past value
  for (const auto& [value, visits] : learned) {
    const double weight = static_cast<double>(visits - before) / static_cast<double>(since);
    news += weight * (value - past) / (1.0 - learning_rates.retainedWeight(before, visits));
  }
  table.set(row, action, past + (1.0 - learning_rates.retainedWeight(before, after)) * news, after);
}

void mergeCopies(const std::vector<const QTable*>& copies, const LearningRateSchedule& learning_rates, Row begin,
                 Row end, QTable& table) {
  std::vector<LearnedValue> learned;
  for (Row row = begin; row < end; ++row) {
    for (Action action = 0; action < table.actions(); ++action) {
      learned.clear();
      const std::uint32_t before = table.visits(row, action);
      for (const QTable* copy : copies) {
        const std::uint32_t visits = copy->visits(row, action);
        if (visits != before) learned.push_back({copy->value(row, action), visits});
      }
      if (!learned.empty()) mergeValue(learned, learning_rates, row, action, table);
    }
  }
}

}  // namespace crowd
