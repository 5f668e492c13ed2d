#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ranks/distributed_evaluation.h"
#include "tools/terminal/progress_bar.h"
#include "training/training.h"

namespace crowd {

/// @brief Requires that all ranks are about to evaluate the same. @throws SharedError
void requireSameRun(Communicator& ranks, const TrainedTable& trained, const std::vector<std::string>& scenario_files,
                    const EvaluationPlan& plan);

/// @brief Requires that all ranks are about to learn the same. @param begin table to begin with; null: an empty one
/// @throws SharedError
void requireSameTraining(Communicator& ranks, const Training& training, const TrainedTable* begin, bool counts_rows);

/// @brief On rank 0, shows the progress within each episode in `bar`, and reports at its end.
RanksObserver observerOf(const std::string& name, const Communicator& ranks, std::optional<ProgressBar>& bar);

}  // namespace crowd
