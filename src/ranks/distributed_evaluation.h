#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "ranks/distributed_crowd.h"
#include "simulation/evaluation/evaluation.h"
#include "training/communicator.h"

namespace crowd {

/// @brief Functions that evaluateOnRanks() calls on each rank; empty ones are skipped.
struct RanksObserver {
  /// At the start of each tick.
  std::function<void(std::uint64_t instance, std::uint64_t tick, std::uint64_t max_ticks)> on_tick;
  std::function<void(const RanksReport& report)> on_report;  ///< after each episode
};

/// @brief Runs scenarios as evaluate() does, one episode after the other: by all ranks together, as a DistributedCrowd,
/// if that can walk the scene, otherwise by rank 0 alone, as for a record of states. The results are the same.
/// Collective.
/// @param plan its `threads` are those of each rank, its stop request that of this one; while rank 0 walks alone, only
/// that of rank 0 ends the episode
/// @param deliver as for evaluate(), but called on rank 0 only
/// @return false if a rank or `deliver` ended it early @throws SharedError on all ranks if one of them throws between
/// episodes or while it walks alone, or if scenes of the ranks differ
bool evaluateOnRanks(Communicator& communicator, const TrainedTable& trained, const ScenarioList& scenarios,
                     const EvaluationPlan& plan, const RanksObserver& observer,
                     const std::function<bool(EvaluatedEpisode&)>& deliver);

/// @brief Checksum of everything in a scene that the motions of a DistributedCrowd depend on.
std::string checksumOf(const Scene& scene);

/// @brief Checksum of the file of the library social_crowd_core, in which a crowd is computed.
std::string checksumOfLibrary();

}  // namespace crowd
