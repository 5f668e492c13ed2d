#include "robot_metric_arguments.h"

namespace crowd {
namespace {

CLI::Range within(const NumberRange& range) { return {range.low, range.high}; }

}  // namespace

void addRobotMetricOptions(CLI::App& app, RobotMetricOptions& options) {
  app.add_option("--progress-distance", options.progress_distance,
                 "a robot fails to progress if it does not come this much nearer to its goal in the time of "
                 "--progress-time [m]")
      ->check(within(RobotMetricOptions::PROGRESS_DISTANCE))
      ->capture_default_str();
  app.add_option("--progress-time", options.progress_time, "see --progress-distance [s]")
      ->check(within(RobotMetricOptions::PROGRESS_TIME))
      ->capture_default_str();
  app.add_option("--stalled-speed", options.stalled_speed, "a robot that is slower is stalled [m/s]")
      ->check(within(RobotMetricOptions::STALLED_SPEED))
      ->capture_default_str();
}

}  // namespace crowd
