#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief The paths of the agents in an episode.
///
/// One point is kept per step [m]. If the number of points of all paths exceeds a maximum, every second point is
/// removed and the step is doubled, so that paths become coarser but not shorter.
class WalkedPaths {
 public:
  struct Path {
    std::vector<Vector2> points;    ///< [m], `map`
    std::size_t settled = 0;        ///< number of points at the front that were already drawn
    Vector2 tip = Vector2::Zero();  ///< present position of the agent [m], `map`
  };

  /// @param step [m], at least 0
  /// @param max_points of all paths together
  WalkedPaths(double step, std::size_t max_points) : first_step_(step), step_(step), max_points_(max_points) {}

  /// @brief Removes all paths.
  void clear();
  /// @brief Adds the present position of an agent [m].
  void add(std::uint32_t agent, const Vector2& position);

  /// @brief Marks all present points as drawn.
  void settle();
  /// @brief Whether points that are marked as drawn have changed since settle().
  bool isUnsettled() const { return unsettled_; }

  /// @brief Returns the paths by number of agent.
  const std::map<std::uint32_t, Path>& paths() const { return paths_; }

 private:
  void thin();

  double first_step_;
  double step_;
  std::size_t max_points_;
  std::size_t point_count_ = 0;
  bool unsettled_ = false;
  std::map<std::uint32_t, Path> paths_;
};

}  // namespace crowd
