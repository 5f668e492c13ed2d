#pragma once

#include <cstdint>
#include <vector>

#include "social_crowd/common/thread_pool.h"
#include "social_crowd/learning/learner.h"
#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/simulation/training_config.h"
#include "social_crowd/simulation/training_state.h"
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

  /// @brief Runs the episodes of the next turn and learns from them. @return these episodes, in order
  std::vector<LearnedEpisode> runNextTurn();
  /// @brief From now on LearnedEpisode::visited_rows is known. This takes one look at the whole table per turn; with a
  /// single learner, one at all.
  void countVisitedRows();
  /// @brief Returns the state between two turns.
  TrainingState state() const;
  /// @brief Goes on from a state of a training with the same configuration; the number of episodes may differ. Episodes
  /// and tables are then the same, bit for bit, as if the training had not been interrupted.
  /// @throws InputError if the state is later than the last episode of the configuration, or, with learners side by
  /// side, within a turn of it; nothing has changed then
  void restore(TrainingState state);
  bool isDone() const { return episode_ >= config_.training.episodes; }
  /// @brief Number of completed episodes.
  std::uint64_t episode() const { return episode_; }
  /// @brief Number of decisions in this training, without those before it.
  std::uint64_t decisions() const { return allDecisions() - decisions_before_; }
  const TrainingConfig& config() const { return config_; }
  const ScenarioList& scenarios() const { return scenarios_; }
  /// @brief The learner; with several side by side, the first.
  const Learner& learner() const { return learners_.front(); }
  /// @brief The table learned so far; with own tables, that of agent 0, the pioneer.
  TrainedTable trained() const;

 private:
  std::uint64_t allDecisions() const;
  /// Each learner runs the next `each` episodes, as far as episodes are left.
  std::vector<LearnedEpisode> runEpisodes(std::uint64_t each);
  LearnedEpisode runOne(std::size_t number, std::uint64_t episode);
  /// Notes the rows with visits in the table that the learners have now.
  void noteVisitedRows();
  void merge(QTable table);

  TrainingConfig config_;
  ScenarioList scenarios_;
  std::vector<Learner> learners_;
  std::vector<std::vector<double>> headings_;  // by learner: of the agents at the end of its last episode [rad]
  ThreadPool thread_pool_;
  std::uint64_t decisions_before_ = 0;
  std::uint64_t episode_ = 0;
  bool counts_rows_ = false;
  Row visited_rows_ = 0;  // of the table at the beginning of the turn, less its QTable::newRows()
};

}  // namespace crowd
