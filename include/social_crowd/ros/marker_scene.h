#pragma once

#include <social_crowd/AgentStates.h>
#include <social_crowd/LearnerStatus.h>
#include <social_crowd/Scenario.h>
#include <visualization_msgs/MarkerArray.h>

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "social_crowd/learning/states/obstacle_classes.h"
#include "social_crowd/learning/states/state_set.h"
#include "social_crowd/ros/marker_paths.h"
#include "social_crowd/ros/tick_messages.h"
#include "social_crowd/world/geometry.h"
#include "social_crowd/world/perception.h"

namespace crowd {

/// @brief Which learner decides for which agent, and so which state set it has.
class KnownStateSets {
 public:
  /// @throws InputError if the model in the status is none.
  void take(const social_crowd::LearnerStatus& status);
  /// @brief Null if no learner is known to serve the agent.
  const StateSet* of(AgentId agent) const;

 private:
  using Shared = std::shared_ptr<const StateSet>;
  std::unordered_map<AgentId, Shared> own_;
  Shared for_all_;
  std::string model_;  // the text that was read last, and what it stands for
  Shared state_set_;
};

/// @brief The middle of the smallest upright rectangle around all that a scenario has: agents, goals, obstacles, walls.
/// What is not finite does not count.
Vector2 middleOf(const social_crowd::Scenario& scenario);

/// @brief What is shown beside the crowd itself, and how.
struct MarkerOptions {
  enum class Radii { NONE, CHOSEN, ALL };
  static constexpr std::int64_t NO_AGENT = -1;

  std::int64_t agent = 0;            ///< the chosen agent, whose occupied sectors are shown; NO_AGENT: none
  Radii radii = Radii::CHOSEN;       ///< around whom the limits of the distance classes are shown
  double path_step = 0.05;           ///< walked from one point of a path to the next [m]
  std::size_t path_points = 40'000;  ///< at most, of all paths together
};

/// @brief All that is known of a crowd from messages, and the markers that show it.
class MarkerScene {
 public:
  explicit MarkerScene(const MarkerOptions& options);

  void take(const social_crowd::AgentStates::ConstPtr& message);
  void take(const social_crowd::Scenario& message);
  /// @throws InputError if what the chosen agent perceives is damaged.
  void take(const PerceptionsMessage& message);
  /// @throws InputError if the model in the status is none; the scene stays as it is.
  void take(const social_crowd::LearnerStatus& message);

  /// @brief Whether anything was taken since draw().
  bool hasChanged() const { return changed_; }

  /// @brief The markers of all kinds; what is not there any more is deleted.
  /// @param whole draw also what is old of the paths, which is much and hardly ever changes; else it is left as it is.
  visualization_msgs::MarkerArray draw(bool whole);

 private:
  void show(const social_crowd::AgentStates::ConstPtr& states);
  const social_crowd::AgentState* findChosen() const;
  visualization_msgs::Marker drawRadii() const;
  visualization_msgs::Marker drawOccupiedSectors() const;

  MarkerOptions options_;
  KnownStateSets state_sets_;
  social_crowd::AgentStates::ConstPtr states_;  // never null
  std::vector<social_crowd::Wall> walls_;
  Perceptions perceptions_;  // of the chosen agent alone, or of nobody
  WalkedPaths paths_;
  bool changed_ = false;
};

}  // namespace crowd
