#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "simulation/episode.h"
#include "simulation/evaluation/robot_log_record.h"

namespace crowd {

/// @brief Records an episode tick by tick, in headless runs and through ROS. What is not wanted stays empty.
class TickRecorder {
 public:
  struct Wanted {
    bool trajectory = false;
    bool robot_series = false;
    bool robot_log = false;
  };
  struct Records {
    std::string trajectory;    ///< rows below TRAJECTORY_HEADER
    std::string robot_series;  ///< rows below robotSeriesHeader()
    std::string robot_log;     ///< lines of a log of robots
  };

  explicit TickRecorder(const Wanted& wanted) : wanted_(wanted) {}

  /// @brief Records the present tick; call it once for each tick, from the start on. @param instance in the rows
  void record(std::uint64_t instance, const Episode& episode);
  /// @brief Returns what was recorded; once, at the end.
  Records take() { return std::move(records_); }

 private:
  Wanted wanted_;
  Records records_;
  RobotLogRecord log_;
};

}  // namespace crowd
