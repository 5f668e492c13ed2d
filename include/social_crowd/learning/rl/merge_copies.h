#pragma once

#include <vector>

#include "social_crowd/learning/rl/learning_rate_schedule.h"
#include "social_crowd/learning/rl/q_table.h"

namespace crowd {

/// @brief Merges what copies of a Q-table have learned, each on its own, into the table they were made from, in the
/// rows begin .. end-1.
///
/// Each value becomes what one learner would hold that had made all the visits: what it was before keeps the share that
/// so many steps leave of it, once and not once a copy; the rest is what the copies learned since, weighted by their
/// visits since. Visits since add up. A value that one copy alone has visited is taken over as it is, and what a value
/// becomes depends on that value alone, not on the others or on how the rows are shared out. Not for copies that were
/// learned with traces: these change values without visits.
void mergeCopies(const std::vector<const QTable*>& copies, const LearningRateSchedule& learning_rates, Row begin,
                 Row end, QTable& table);

}  // namespace crowd
