#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "common/thread_pool.h"
#include "learning/learner.h"
#include "learning/q_table_file.h"
#include "scenario/scenario.h"
#include "training/communicator.h"
#include "training/training_config.h"
#include "training/training_state.h"
#include "training/turns_report.h"

namespace crowd {

/// @brief Training without ROS, turn by turn. The result depends only on training configuration and seed, not on the
/// number of threads or ranks.
///
/// A single learner learns one episode per turn. With several learners side by side, each learns `turn` consecutive
/// episodes in its own copy of the table; then the copies are merged, and the next turn starts with the merged table.
/// The caller repeats runNextTurn() until isDone(). Not thread-safe.
///
/// On several ranks, each has a Training of the same configuration and state, with a block of the learners.
/// runNextTurn() and report() are collective. All ranks have the same table and number of episodes after each turn.
/// Only rank 0 knows the episodes, decisions and headings of all learners; others know those of their own ones.
class Training {
 public:
  /// @brief Starts with an empty table. @param threads maximum number of episodes that run at the same time,
  /// on each rank
  /// @param communicator the ranks; must outlive the training
  /// @throws FileError, InputError if a scenario file cannot be read; InputError if the training configuration combines
  /// learners side by side with traces or with own tables, or if there are more ranks than learners.
  explicit Training(TrainingConfig config, unsigned threads = 1,
                    Communicator& communicator = SingleProcess::instance());
  /// @brief Continues from an existing table, with model and parameters of the training configuration; decisions
  /// accumulate.
  /// @throws ShapeError if the table is for another state set or action set; otherwise as above.
  Training(TrainingConfig config, TrainedTable begin, unsigned threads = 1,
           Communicator& communicator = SingleProcess::instance());

  /// @brief Runs the episodes of the next turn and learns from them. @return these episodes, in order; on other ranks
  /// than 0, nothing @throws SharedError on all of several ranks if an episode throws on one
  std::vector<LearnedEpisode> runNextTurn();
  /// @brief Sets LearnedEpisode::visited_rows in all later turns. For that, the whole table is read once in each turn
  /// with several learners, and once in the training with a single one. Collective.
  void countVisitedRows();
  /// @brief Returns the state between two turns; on rank 0.
  TrainingState state() const;
  /// @brief Goes on from a state of a training with the same configuration; the number of episodes may differ. Episodes
  /// and tables are then the same, bit for bit, as if the training had not been interrupted.
  /// @throws InputError if the state is later than the last episode of the configuration, or, with learners side by
  /// side, within a turn of it; nothing has changed then
  void restore(TrainingState state);
  bool isDone() const { return episode_ >= config_.training.episodes; }
  /// @brief Number of completed episodes.
  std::uint64_t episode() const { return episode_; }
  /// @brief Number of decisions in this training, without those before it; on rank 0.
  std::uint64_t decisions() const { return allDecisions() - decisions_before_; }
  const TrainingConfig& config() const { return config_; }
  const ScenarioList& scenarios() const { return scenarios_; }
  /// @brief Number of learners side by side, of all ranks.
  std::size_t learners() const { return decisions_.size(); }
  /// @brief The learner; with several side by side, the first one of this rank.
  const Learner& learner() const { return learners_.front(); }
  /// @brief The table learned so far; with own tables, that of agent 0. Its number of decisions is that of all
  /// learners on rank 0.
  TrainedTable trained() const;
  /// @brief Times of the turns so far. Collective; on rank 0, of all ranks.
  TurnsReport report() const;

 private:
  std::uint64_t allDecisions() const;
  /// A turn: `each` episodes for each learner, as far as episodes are left.
  struct Turn {
    std::uint64_t each = 1;
    std::uint64_t episodes = 0;  // of all learners

    std::uint64_t begin(std::size_t learner) const { return std::min(learner * each, episodes); }
    std::uint64_t end(std::size_t learner) const { return begin(learner + 1); }
  };

  /// The learners of this rank run their episodes. Returns these.
  std::vector<LearnedEpisode> runEpisodes(const Turn& turn);
  /// @param own number of the learner among those of this rank
  LearnedEpisode runOne(std::size_t own, std::uint64_t episode);
  /// Rank 0 gets the episodes of all ranks, others keep none.
  void collect(std::vector<LearnedEpisode>& episodes);
  /// Notes decisions and headings of the learners. @param first the learner that the first episode is of
  void note(const Turn& turn, std::size_t first, const std::vector<LearnedEpisode>& episodes);
  /// Notes the rows with visits in the table that the learners have now.
  void noteVisitedRows();
  void merge(QTable table);

  TrainingConfig config_;
  Communicator& communicator_;
  ScenarioList scenarios_;
  std::size_t first_;                          // of all learners, the first of this rank
  std::vector<Learner> learners_;              // of this rank
  std::vector<std::uint64_t> decisions_;       // of all learners
  std::vector<std::vector<double>> headings_;  // of all learners: of the agents at the end of the last episode [rad]
  ThreadPool thread_pool_;
  std::uint64_t decisions_before_ = 0;
  std::uint64_t episode_ = 0;
  bool counts_rows_ = false;
  Row visited_rows_ = 0;  // of the table at the beginning of the turn, less its QTable::newRows()
  TurnTimes times_;
};

}  // namespace crowd
