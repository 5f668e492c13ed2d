#pragma once

#include <vector>

#include "common/thread_pool.h"
#include "learning/rl/learning_rate_schedule.h"
#include "learning/rl/q_table.h"
#include "training/communicator.h"

namespace crowd {

/// @brief Merges copies of a table that learners on all ranks have learned in, as mergeCopies() does with those of one
/// process: the result is the same, bit for bit. Collective; afterwards all ranks have the same table.
///
/// The sum over the learners has one order. Therefore values are not added up on the way: each rank sends the values
/// that its learners have visited to the rank that merges their row (a reduce-scatter), which sends the merged ones to
/// all (an allgather). Only visited values are sent.
/// @param copies of this rank's learners; those of lower ranks are before them in the order of the learners
/// @param table the one that all copies were made of, the same on all ranks
/// @param thread_pool its threads share the copies
void mergeOnRanks(Communicator& communicator, const std::vector<const QTable*>& copies,
                  const LearningRateSchedule& learning_rates, ThreadPool& thread_pool, QTable& table);

}  // namespace crowd
