#include "robot_metric_arguments.h"

namespace crowd {

void addRobotMetricOptions(CLI::App& app, RobotMetricOptions& options) {
  app.add_option("--progress-distance", options.progress_distance,
                 "a robot fails to progress if it does not come this much nearer to its goal in the time of "
                 "--progress-time [m]")
      ->check(CLI::Range(1e-6, 1e6))
      ->capture_default_str();
  app.add_option("--progress-time", options.progress_time, "see --progress-distance [s]")
      ->check(CLI::Range(1e-6, 1e6))
      ->capture_default_str();
  app.add_option("--stalled-speed", options.stalled_speed, "a robot that is slower is stalled [m/s]")
      ->check(CLI::Range(0.0, 1e3))
      ->capture_default_str();
}

}  // namespace crowd
