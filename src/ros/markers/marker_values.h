#pragma once

#include <social_crowd/DecisionValues.h>
#include <visualization_msgs/MarkerArray.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace crowd {

/// @brief Draws the candidate moves of a decision around the agent: a wedge for each, as long as the move is fast (the
/// part that the separation rule forbids is faint), coloured by its value between the worst and the best of the
/// decision; the chosen one has an outline. A text at each tells how often it was tried. Staying is a ring.
///
/// Used by MarkerScene in the thread of crowd_markers.
class ValuesDrawing {
 public:
  /// @param decision null: deletes all markers. One with values that cannot be drawn is not drawn, either
  /// @param radius of the body of the agent [m]
  void draw(const social_crowd::DecisionValues* decision, double radius, visualization_msgs::MarkerArray& array);

 private:
  std::size_t most_texts_ = 0;  // that a drawing had so far
};

/// @brief Number of visits in at most four characters: 950, 1.2k, 35k, 1.2M.
std::string visitsText(std::uint32_t visits);

}  // namespace crowd
