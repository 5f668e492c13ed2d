#pragma once

#include <social_crowd/AgentStates.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <set>
#include <utility>

#include "ros/markers/marker_gait.h"

namespace crowd {

/// @brief Agents as walking people, with what they have with them: mesh markers of the files in meshes/ (see
/// scripts/draw_figures), several for each agent.
///
/// Used by MarkerScene in the thread of crowd_markers.
class WalkingFigures {
 public:
  enum class Of { AGENTS, RECORDED };  ///< recorded people, whose numbers are those of their obstacles

  explicit WalkingFigures(Of people = Of::AGENTS) : people_(people) {}

  /// @brief Takes the state after each tick, so that the figures step with the distance walked, also while not drawn.
  void take(const social_crowd::AgentStates& states);
  /// @brief Forgets how far the agents have walked.
  void clear() { cycles_.clear(); }

  /// @brief Adds the markers of the agents on the floor, and deletes those of agents that have left it.
  /// @param shown false: deletes all figures
  /// @param whole whether this drawing also has what earlier ones had: markers are deleted again until a whole drawing,
  /// in case a message was lost
  void draw(const social_crowd::AgentStates& states, bool shown, bool whole, visualization_msgs::MarkerArray& array);

 private:
  Of people_;
  WalkingCycles cycles_;
  using Part = std::pair<std::uint32_t, std::size_t>;  // agent, and part of its figure
  std::set<Part> shown_;
  std::set<Part> leaving_;  // are being deleted
};

}  // namespace crowd
