#pragma once

#include <vector>

#include "social_crowd/learning/rl/learning_rate_schedule.h"
#include "social_crowd/learning/rl/q_table.h"

namespace crowd {

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
