#pragma once

#include <cmath>
#include <cstdint>

#include "robots/metrics/measured_time.h"
#include "robots/metrics/robot_sample.h"
#include "robots/metrics/statistic.h"
#include "social_crowd/robot_result.h"

namespace crowd {

/// @brief How a robot moved in an episode: speed, acceleration, jerk, rotation.
class MotionMeasures {
 public:
  /// @brief Adds a tick. @param last sample of the tick before @param stalled_speed see RobotMetricOptions [m/s]
  void add(const RobotSample& sample, const RobotSample& last, double stalled_speed, double tick_duration) {
    const double turn = sample.jumped ? 0.0 : std::abs(wrapAngle(sample.pose.heading - last.pose.heading));
    rotation_ += turn;
    speed_.add(sample.speed);
    acceleration_.addNumber(sample.acceleration);
    jerk_.addNumber(sample.jerk);
    const bool is_still = sample.speed < STILL_SPEED && turn < STILL_ROTATION * tick_duration;
    still_ticks_ += is_still ? 1 : 0;
    stalled_ticks_ += sample.speed < stalled_speed ? 1 : 0;
  }

  /// @brief Sum of the absolute rotations [rad].
  double rotation() const { return rotation_; }

  void write(const MeasuredTime& time, RobotResult& result) const {
    result.stalled_time = time.seconds(stalled_ticks_);
    result.min_speed = speed_.least();
    result.avg_robot_linear_speed = speed_.mean();
    result.max_speed = greatestOf(speed_);
    if (time.ticks > 0) result.avg_robot_angular_speed = rotation_ / time.seconds();
    result.min_acceleration = acceleration_.least();
    result.avg_acceleration = acceleration_.mean();
    result.max_acceleration = greatestOf(acceleration_);
    result.min_jerk = jerk_.least();
    result.avg_jerk = jerk_.mean();
    result.max_jerk = greatestOf(jerk_);
    result.cumulative_heading_changes = rotation_;
    result.time_not_moving = time.seconds(still_ticks_);
  }

 private:
  static constexpr double STILL_SPEED = 0.001;    // [m/s]
  static constexpr double STILL_ROTATION = 0.01;  // [rad/s]

  /// The greatest of some numbers; 0 without any.
  static double greatestOf(const Statistic& numbers) { return numbers.count() == 0 ? 0.0 : numbers.greatest(); }

  Statistic speed_;
  Statistic acceleration_;
  Statistic jerk_;
  double rotation_ = 0.0;
  std::uint64_t still_ticks_ = 0;
  std::uint64_t stalled_ticks_ = 0;
};

}  // namespace crowd
