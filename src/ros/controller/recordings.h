#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "common/files/growing_file.h"
#include "ros/controller/controller_parameters.h"
#include "simulation/evaluation/tick_recorder.h"
#include "simulation/evaluation/trajectory.h"

namespace crowd {

/// @brief The files in which the crowd controller records a scenario, as far as its parameters want them. An episode
/// gets into them when it is over.
class Recordings {
 public:
  /// @brief Creates or truncates the files. @param name of the scenario @throws FileError; then no file has changed
  Recordings(const ControllerParameters& parameters, const std::string& name);

  /// @brief Begins an episode; one that is not over is forgotten.
  void begin() { recorder_.emplace(wanted_); }
  /// @brief Records the present tick; once for each tick. @param instance since the files were made
  void record(std::uint64_t instance, const Episode& episode) { recorder_->record(instance, episode); }
  /// @brief Appends the episode, which is over. @throws FileError
  void finish();

 private:
  TickRecorder::Wanted wanted_;
  std::optional<TickRecorder> recorder_;  // of the present episode
  std::optional<TrajectoryFile> trajectories_;
  std::optional<GrowingFile> robot_series_;
  std::optional<GrowingFile> robot_logs_;
};

}  // namespace crowd
