#pragma once

#include <cstdint>
#include <vector>

#include "geometry/geometry.h"
#include "scenario/robot_metric_options.h"

namespace crowd {

/// @brief Whether a robot gets on: failures to progress, and whether it is stuck.
class Progress {
 public:
  Progress() = default;
  /// @param tick_duration [s]
  Progress(const RobotMetricOptions& options, double tick_duration);

  /// @brief Begins a goal, at a distance from it [m].
  void beginGoal(double distance);
  /// @brief The robot is at a place at the end of a tick. @param distance to its goal [m]; NaN without a goal
  void add(const Vector2& place, double distance);

  /// @brief Times that the robot did not come `progress_distance` nearer to its goal in `progress_time`.
  std::uint64_t failures() const { return failures_; }
  /// @brief Whether it moved by less than `progress_distance` in the last `progress_time`.
  bool isStuck() const;

 private:
  std::size_t remembered() const { return span_ + 1; }  // positions

  RobotMetricOptions options_;
  std::size_t span_ = 0;  // ticks of `progress_time`
  std::uint64_t ticks_ = 0;
  std::vector<Vector2> recent_;  // positions of the last `progress_time`, in a ring
  std::uint64_t failures_ = 0;
  double start_distance_ = 0.0;    // to the goal, when it last made progress or failed to [m]
  std::uint64_t since_start_ = 0;  // ticks from then on
};

}  // namespace crowd
