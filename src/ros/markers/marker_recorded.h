#pragma once

#include <social_crowd/AgentStates.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <map>

#include "ros/markers/marker_figures.h"

namespace crowd {

/// @brief Recorded people: discs with arrows, or walking people, of one colour that agents do not have.
///
/// Used by MarkerScene in the thread of crowd_markers.
class RecordedDrawing {
 public:
  /// @brief Takes the state after each tick. People face where they walk; who stands, where they walked last.
  void take(const social_crowd::AgentStates& states);
  /// @brief Forgets how far they have walked.
  void clear();
  /// @brief Adds the markers of the people who are there, and deletes those of the others.
  /// @param figures whether they are walking people @param whole see WalkingFigures
  void draw(bool figures, bool whole, visualization_msgs::MarkerArray& array);

 private:
  social_crowd::AgentStates people_;          // as agents with the numbers of the obstacles
  std::map<std::uint32_t, double> headings_;  // [rad] by these numbers
  WalkingFigures figures_{WalkingFigures::Of::RECORDED};
  bool is_drawn_ = false;  // since there was nobody
};

}  // namespace crowd
