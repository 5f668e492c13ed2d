#pragma once

#include "learning/learner.h"
#include "learning/q_table_file.h"

namespace crowd {

/// A learner in demo mode with the shipped table `anticipation`.
inline Learner anticipationLearner() {
  const TrainedTable trained = loadQTable(SOURCE_DIR "/config/q_tables/anticipation.txt");
  Learner::Options options;
  options.plan.parameters = trained.parameters;
  return {trained.model, options, trained.table};
}

}  // namespace crowd
