#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "social_crowd/q_table.h"
#include "social_crowd/results.h"

namespace crowd::library {

struct TrainingOptions {
  std::optional<std::uint64_t> episodes;  ///< overrides the configuration
  std::optional<std::uint64_t> seed;      ///< overrides the configuration
  std::optional<QTable> begin;            ///< learning goes on from this table; else from an empty one
  unsigned threads = 0;  ///< for learners side by side; 0: one per processor. Results do not depend on it
};

/// @brief An episode of a training: its result, and what was learned in it.
struct LearnedEpisode : EpisodeResult {
  std::uint64_t decisions = 0;  ///< that were learned from
  double reward = 0.0;          ///< mean reward of these decisions; NaN without any
  double epsilon = 0.0;         ///< probability of a random action
};

/// @brief Learns a Q-table as the program `train` does, turn by turn, until isDone(), or as long as you like. Use an
/// object from one thread at a time.
class Training {
 public:
  /// @param config a configuration file (docs/learning.md)
  /// @throws FileError if it or a scenario cannot be read; InputError with file, line and what was expected; ShapeError
  /// if the table to begin with is for another state set or action set
  explicit Training(const std::string& config, const TrainingOptions& options = {});
  Training(Training&&) noexcept;
  Training& operator=(Training&&) noexcept;
  ~Training();

  /// @brief Runs the episodes of a turn, one for a single learner, and learns from them. @return these episodes
  std::vector<LearnedEpisode> runNextTurn();
  bool isDone() const;
  /// @brief Number of episodes so far.
  std::uint64_t episode() const;
  /// @brief Number of episodes of the whole training.
  std::uint64_t episodes() const;
  /// @brief Number of decisions so far, without those of the table that it began with.
  std::uint64_t decisions() const;
  /// @brief A copy of what was learned so far.
  QTable table() const;

  /// @brief Writes a file from which an interrupted training goes on. @throws FileError
  void saveCheckpoint(const std::string& file) const;
  /// @brief Goes on from a checkpoint of the same configuration and seed; episodes and tables are then the same, bit
  /// for bit, as without the interruption. @throws FileError if it cannot be read; InputError if it is damaged or of
  /// another training; nothing has changed then
  void resume(const std::string& file);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crowd::library
