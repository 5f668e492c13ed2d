#pragma once

#include <cstdint>

#include "social_crowd/learning/learner.h"
#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/simulation/episode_result.h"
#include "social_crowd/simulation/recipe.h"
#include "social_crowd/world/scenario.h"

namespace crowd {

/// @brief Plays an episode to its end with one learner.
EpisodeResult runEpisode(const Scene& scene, std::uint64_t number, Learner& learner);

/// @brief Training without ROS, episode by episode. Depends on recipe and seed alone.
class Training {
 public:
  /// @brief From nothing. @throws FileError, InputError if a scenario file cannot be read.
  explicit Training(Recipe recipe);
  /// @brief Goes on from what was learned before; model and parameters are the recipe's, decisions add up.
  /// @throws ShapeError if the table is of another state set or action set; else as above.
  Training(Recipe recipe, TrainedTable begin);

  /// @brief Walks the next episode and learns from it.
  EpisodeResult runNextEpisode();
  bool isDone() const { return episode_ >= recipe_.training.episodes; }
  std::uint64_t episode() const { return episode_; }
  /// @brief Decisions learned from in this training.
  std::uint64_t decisions() const { return learner_.decisions() - decisions_before_; }
  const Recipe& recipe() const { return recipe_; }
  const Learner& learner() const { return learner_; }
  /// @brief What was learned so far; with own tables that of agent 0, the pioneer.
  TrainedTable trained() const;

 private:
  Recipe recipe_;
  ScenarioList scenarios_;
  Learner learner_;
  std::uint64_t decisions_before_ = 0;
  std::uint64_t episode_ = 0;
};

}  // namespace crowd
