#pragma once

#include "common/text/number_range.h"

namespace crowd {

/// @brief What the metrics of robots depend on besides the episode (docs/metrics.md).
struct RobotMetricOptions {
  static constexpr NumberRange PROGRESS_DISTANCE{1e-6, 1e6, "m"};
  static constexpr NumberRange PROGRESS_TIME{1e-6, 1e6, "s"};
  static constexpr NumberRange STALLED_SPEED{0.0, 1e3, "m/s"};

  /// A robot fails to progress if it does not come this much nearer to its goal in `progress_time`, and is stuck if it
  /// moved by less in the last `progress_time` [m].
  double progress_distance = 0.5;
  double progress_time = 10.0;  ///< [s]
  double stalled_speed = 0.05;  ///< a robot that is slower is stalled [m/s]
};

}  // namespace crowd
