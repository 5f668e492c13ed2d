#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "progress_bar.h"
#include "social_crowd/simulation/distributed_evaluation.h"

namespace crowd {

/// @brief Runs a tool on one or several ranks. An error that all ranks know of is printed once, by rank 0; one that
/// only one rank knows of ends all.
/// @return the exit status
int runOnAllRanks(Communicator& ranks, const std::string& tool, const std::function<int()>& run);

/// @brief Requires that all ranks are about to do the same. @throws SharedError
void requireSameRun(Communicator& ranks, const TrainedTable& trained, const std::vector<std::string>& scenario_files,
                    const EvaluationPlan& plan);

/// @brief Ends the episodes when this rank is interrupted; on rank 0, shows the progress within each episode in `bar`,
/// and reports at its end.
RanksObserver observerOf(const std::string& name, const Communicator& ranks, std::optional<ProgressBar>& bar);

}  // namespace crowd
