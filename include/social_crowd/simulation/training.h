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

/// @brief Plays an episode to its end with one learner, which decides for all agents.
EpisodeResult runEpisode(const Scene& scene, std::uint64_t number, Learner& learner);

/// @brief Training without ROS, turn by turn. Depends on training configuration and seed alone, not on the number of
/// threads.
///
/// One learner learns an episode a turn. Several side by side learn `turn` episodes each, one after the other, in a
/// copy of the table of their own; then the copies are merged, and the next turn begins with what came of it.
class Training {
 public:
  /// @brief From nothing. @param threads how many at most walk episodes at the same time
  /// @throws FileError, InputError if a scenario file cannot be read; InputError if the training configuration asks for
  /// learners side by side with traces or with own tables.
  explicit Training(TrainingConfig config, unsigned threads = 1);
  /// @brief Goes on from what was learned before; model and parameters are the training configuration's, decisions add
  /// up.
  /// @throws ShapeError if the table is of another state set or action set; else as above.
  Training(TrainingConfig config, TrainedTable begin, unsigned threads = 1);

  /// @brief Walks the episodes of the next turn and learns from them. @return how they went, in order.
  std::vector<EpisodeResult> runNextTurn();
  bool isDone() const { return episode_ >= config_.training.episodes; }
  /// @brief Episodes done.
  std::uint64_t episode() const { return episode_; }
  /// @brief Decisions learned from in this training.
  std::uint64_t decisions() const { return allDecisions() - decisions_before_; }
  const TrainingConfig& config() const { return config_; }
  /// @brief The learner; of several side by side the first.
  const Learner& learner() const { return learners_.front(); }
  /// @brief What was learned so far; with own tables that of agent 0, the pioneer.
  TrainedTable trained() const;

 private:
  std::uint64_t allDecisions() const;
  /// Each learner walks so many of the next episodes, as long as there are any.
  std::vector<EpisodeResult> runEpisodes(std::uint64_t each);
  void merge(QTable table);

  TrainingConfig config_;
  ScenarioList scenarios_;
  std::vector<Learner> learners_;
  std::vector<std::vector<double>> headings_;  // by learner: of its agents at the end of its last episode [rad]
  ThreadPool thread_pool_;
  std::uint64_t decisions_before_ = 0;
  std::uint64_t episode_ = 0;
};

}  // namespace crowd
