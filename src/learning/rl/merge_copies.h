#pragma once

#include <cstdint>
#include <vector>

#include "learning/rl/learning_rate_schedule.h"
#include "learning/rl/q_table.h"

namespace crowd {

/// @brief What a copy of a Q-table has learned of one value.
struct LearnedValue {
  double value = 0.0;
  std::uint32_t visits = 0;  ///< more than before
};

/// @brief Merges what copies have learned of one value into the table that they were copied from; see mergeCopies().
/// Floating-point sums depend on the order of `learned`.
/// @param learned by the copies that have visited the value since, in the order of the learners; at least one
void mergeValue(const std::vector<LearnedValue>& learned, const LearningRateSchedule& learning_rates, Row row,
                Action action, QTable& table);

/// @brief Merges copies of a Q-table that have learned independently into the table that they were copied from, in the
/// rows begin .. end-1.
///
/// Each value becomes that of one learner with the visits of all copies: the old value keeps the weight that this
/// number of visits leaves of it (LearningRateSchedule::retainedWeight()); the rest is the mean of what the copies have
/// learned since, weighted by their visits since. The visits since are added. A value that only one copy has visited is
/// taken over unchanged. Entries are independent of each other, so threads may merge disjoint ranges of rows
/// concurrently. Not valid for copies that were learned with traces, which change values without visits.
/// @param copies of the same shape as the table, with at least its visits
void mergeCopies(const std::vector<const QTable*>& copies, const LearningRateSchedule& learning_rates, Row begin,
                 Row end, QTable& table);

}  // namespace crowd
