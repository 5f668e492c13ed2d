#pragma once

#include <nav_msgs/OccupancyGrid.h>
#include <social_crowd/AgentStates.h>
#include <social_crowd/DecisionValues.h>
#include <social_crowd/LearnerStatus.h>
#include <social_crowd/RobotStates.h>
#include <social_crowd/Scenario.h>
#include <social_crowd/Walls.h>
#include <visualization_msgs/MarkerArray.h>

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/geometry.h"
#include "learning/states/obstacle_classes.h"
#include "learning/states/state_set.h"
#include "ros/markers/marker_figures.h"
#include "ros/markers/marker_paths.h"
#include "ros/markers/marker_recorded.h"
#include "ros/markers/marker_values.h"
#include "ros/messages/tick_messages.h"
#include "world/perception.h"

namespace crowd {

/// @brief The state set of each agent, from the status of the learner that serves it.
class KnownStateSets {
 public:
  /// @throws InputError if the model in the status is invalid
  void take(const social_crowd::LearnerStatus& status);
  /// @brief Returns the state set of an agent; null if no learner has reported that it serves the agent.
  const StateSet* of(AgentId agent) const;

 private:
  using Shared = std::shared_ptr<const StateSet>;
  std::unordered_map<AgentId, Shared> own_;
  Shared for_all_;
  std::string model_;  // text of the last model parsed; state_set_ is its state set
  Shared state_set_;
};

/// @brief Returns the bounding box of a scenario: agents, goals, obstacles, walls [m], `map`. Positions that are not
/// finite are ignored. Without any, the box is empty.
Eigen::AlignedBox2d boundsOf(const social_crowd::Scenario& scenario);
/// @brief Returns the centre of this box, or the origin; the frame `crowd` is there, rounded to metres.
Vector2 middleOf(const social_crowd::Scenario& scenario);

/// @brief The state of agents and obstacles at the start of an episode.
social_crowd::AgentStates::ConstPtr statesAtStart(const social_crowd::Scenario& scenario);

/// @brief Options of the visualisation.
struct MarkerOptions {
  enum class Radii { NONE, CHOSEN, ALL };
  enum class Figures { AUTO, DISCS, PEOPLE };
  static constexpr std::int64_t NO_AGENT = -1;
  static constexpr std::size_t MOST_FIGURES = 200;  ///< with AUTO, larger crowds are shown as discs

  std::int64_t agent = 0;            ///< the agent whose occupied sectors and values are shown; NO_AGENT: none
  Radii radii = Radii::CHOSEN;       ///< agents around which the limits of the distance classes are shown
  Figures figures = Figures::AUTO;   ///< agents as discs or as walking people
  double path_time = 0.0;            ///< time for which walked paths are shown [s]; 0: see pathTimeFor()
  double path_step = 0.05;           ///< distance between two points of a path [m]
  std::size_t path_points = 40'000;  ///< maximum number of points of all paths together
};

/// @brief Collects the messages of a crowd and draws the markers that show it.
class MarkerScene {
 public:
  explicit MarkerScene(const MarkerOptions& options);

  void take(const social_crowd::AgentStates::ConstPtr& message);
  void take(const social_crowd::RobotStates::ConstPtr& message);
  void take(const social_crowd::Scenario& message);
  void take(const social_crowd::Walls& message);
  /// @brief An empty map means that there is none. @throws InputError if the map is invalid; nothing has changed then
  void take(const nav_msgs::OccupancyGrid& message);
  /// @throws InputError if the perception of the chosen agent is invalid
  void take(const PerceptionsMessage& message);
  void take(const social_crowd::DecisionValues::ConstPtr& message);
  /// @throws InputError if the model in the status is invalid; nothing has changed then
  void take(const social_crowd::LearnerStatus& message);

  /// @brief Chooses the agent whose occupied sectors and values are shown; NO_AGENT: none.
  void choose(std::int64_t agent);

  /// @brief Whether the scene has changed since draw().
  bool hasChanged() const { return changed_; }

  /// @brief Returns all markers; markers without content are deleted in RViz.
  /// @param whole also draw the map and the settled parts of the paths, which are large and rarely change
  visualization_msgs::MarkerArray draw(bool whole);

 private:
  bool showsFigures() const;
  /// Returns the number of agents on the floor.
  std::size_t countWalkers() const;
  double pathTime(std::size_t walkers) const;
  void show(const social_crowd::AgentStates::ConstPtr& states);
  const social_crowd::AgentState* findChosen() const;
  visualization_msgs::Marker drawRadii() const;
  visualization_msgs::Marker drawOccupiedSectors() const;
  void drawValues(visualization_msgs::MarkerArray& array);

  MarkerOptions options_;
  KnownStateSets state_sets_;
  social_crowd::AgentStates::ConstPtr states_;  // never null
  std::vector<social_crowd::Wall> walls_;
  visualization_msgs::Marker map_;                   // drawn when the map came
  bool map_changed_ = false;                         // since draw()
  Perceptions perceptions_;                          // of the chosen agent only, or empty
  social_crowd::DecisionValues::ConstPtr decision_;  // of the chosen agent, or null
  ValuesDrawing values_;
  WalkedPaths paths_;
  std::size_t most_walkers_ = 0;  // at a time in the episode
  WalkingFigures figures_;
  RecordedDrawing recorded_;
  social_crowd::RobotStates::ConstPtr robots_;  // never null
  WalkedPaths robot_paths_;
  bool changed_ = false;
};

}  // namespace crowd
