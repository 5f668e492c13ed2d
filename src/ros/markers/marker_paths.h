#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "geometry/geometry.h"

namespace crowd {

/// @brief Time for which walked paths are shown, so that they do not cover the floor [s]: shorter for many walkers.
double pathTimeFor(std::size_t walkers);

/// @brief The paths of the agents in an episode, as far as they are not older than a time.
///
/// One point is kept per step [m]. If the number of points of all paths exceeds a maximum, every second point is
/// removed and the step is doubled, so that paths become coarser but not shorter. Times are simulated times of the
/// episode.
class WalkedPaths {
 public:
  struct Point {
    Vector2 position = Vector2::Zero();  ///< [m], `map`
    double time = 0.0;                   ///< when the agent was there [s]
  };
  struct Path {
    std::vector<Point> points;      ///< oldest first
    std::size_t settled = 0;        ///< number of points at the front that were already drawn
    Vector2 tip = Vector2::Zero();  ///< present position of the agent [m], `map`
    double tip_time = 0.0;          ///< when it arrived there [s]
    double last_time = 0.0;         ///< when it was last there [s]
  };

  /// @param step [m], at least 0
  /// @param max_points of all paths together
  WalkedPaths(double step, std::size_t max_points) : first_step_(step), step_(step), max_points_(max_points) {}

  /// @brief Removes all paths.
  void clear();
  /// @brief Sets the present time, and the time for which paths are shown [s].
  void setTimes(double now, double shown);
  /// @brief Adds the present position of an agent [m].
  void add(std::uint32_t agent, const Vector2& position);

  /// @brief Removes points that are too old, and marks all others as drawn.
  void settle();
  /// @brief Whether points that are marked as drawn have changed since settle(), or become clearly fainter.
  bool isUnsettled() const;
  /// @brief How clearly a point of this time is shown: 1 now, 0 when it is too old.
  double strengthAt(double time) const;

  /// @brief Returns the paths by number of agent.
  const std::map<std::uint32_t, Path>& paths() const { return paths_; }

 private:
  void thin();
  /// Removes points that are too old, and the paths of agents that have left when they are not shown any more.
  void forgetOld();

  double first_step_;
  double step_;
  std::size_t max_points_;
  std::size_t point_count_ = 0;
  bool unsettled_ = false;
  double now_ = 0.0;           // [s]
  double shown_ = 1e9;         // [s]
  double settled_time_ = 0.0;  // time of the last settle() [s]
  std::map<std::uint32_t, Path> paths_;
};

}  // namespace crowd
