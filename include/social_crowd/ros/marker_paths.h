#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "social_crowd/world/geometry.h"

namespace crowd {

/// @brief The paths that agents walked in an episode, from their start to where they are now.
///
/// A point is kept for every step [m] walked. All paths together have a limited number of points: beyond it every
/// second one is dropped and the step doubled, so that paths get coarser and never shorter.
class WalkedPaths {
 public:
  struct Path {
    std::vector<Vector2> points;    ///< [m], `map`
    std::size_t settled = 0;        ///< so many points at the front stay as they are and were drawn before
    Vector2 tip = Vector2::Zero();  ///< where the agent is now [m], `map`
  };

  /// @param step [m], at least 0
  /// @param max_points of all paths together
  WalkedPaths(double step, std::size_t max_points) : first_step_(step), step_(step), max_points_(max_points) {}

  /// @brief Forgets everything.
  void clear();
  /// @brief An agent is there now [m].
  void add(std::uint32_t agent, const Vector2& position);

  /// @brief All points there are now count as drawn.
  void settle();
  /// @brief Whether points that count as drawn have changed since settle().
  bool isUnsettled() const { return unsettled_; }

  /// @brief The paths by number of agent.
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
