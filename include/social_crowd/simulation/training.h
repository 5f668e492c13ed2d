#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/common/thread_pool.h"
#include "social_crowd/learning/learner.h"
#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/simulation/episode_result.h"
#include "social_crowd/simulation/training_config.h"
#include "social_crowd/world/scenario.h"

namespace crowd {

/// @brief Training without ROS, turn by turn. The result depends only on training configuration and seed, not on the
/// number of threads.
///
/// A single learner learns one episode per turn. With several learners side by side, each learns `turn` consecutive
/// episodes in its own copy of the table; then the copies are merged, and the next turn starts with the merged table.
/// The caller repeats runNextTurn() until isDone(). Not thread-safe.
class Training {
 public:
  /// @brief Starts with an empty table. @param threads maximum number of episodes that run at the same time
  /// @throws FileError, InputError if a scenario file cannot be read; InputError if the training configuration combines
  /// learners side by side with traces or with own tables.
  explicit Training(TrainingConfig config, unsigned threads = 1);
  /// @brief Continues from an existing table, with model and parameters of the training configuration; decisions
  /// accumulate.
  /// @throws ShapeError if the table is for another state set or action set; otherwise as above.
  Training(TrainingConfig config, TrainedTable begin, unsigned threads = 1);

  /// @brief Runs the episodes of the next turn and learns from them. @return their results, in order
  std::vector<EpisodeResult> runNextTurn();
  bool isDone() const { return episode_ >= config_.training.episodes; }
  /// @brief Number of completed episodes.
  std::uint64_t episode() const { return episode_; }
  /// @brief Number of decisions in this training, without those before it.
  std::uint64_t decisions() const { return allDecisions() - decisions_before_; }
  const TrainingConfig& config() const { return config_; }
  /// @brief The learner; with several side by side, the first.
  const Learner& learner() const { return learners_.front(); }
  /// @brief The table learned so far; with own tables, that of agent 0, the pioneer.
  TrainedTable trained() const;

 private:
  std::uint64_t allDecisions() const;
  /// Each learner runs the next `each` episodes, as far as episodes are left.
  std::vector<EpisodeResult> runEpisodes(std::uint64_t each);
  void merge(QTable table);

  TrainingConfig config_;
  ScenarioList scenarios_;
  std::vector<Learner> learners_;
  std::vector<std::vector<double>> headings_;  // by learner: of the agents at the end of its last episode [rad]
  ThreadPool thread_pool_;
  std::uint64_t decisions_before_ = 0;
  std::uint64_t episode_ = 0;
};

}  // namespace crowd
