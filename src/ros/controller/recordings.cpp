#include "ros/controller/recordings.h"

#include "common/files/files.h"
#include "simulation/evaluation/robot_series.h"

namespace crowd {
namespace {

/// Returns the file of this name in a folder, which it creates, after a check that the file can be written; nothing
/// without a folder.
std::optional<std::string> fileIn(const std::string& folder, const std::string& name) {
  if (folder.empty()) return std::nullopt;
  makeFolder(folder);
  requireGrowable(folder + "/" + name);
  return folder + "/" + name;
}

}  // namespace

Recordings::Recordings(const ControllerParameters& parameters, const std::string& name)
    : wanted_{!parameters.trajectories.empty(), !parameters.robot_series.empty(), !parameters.robot_logs.empty()} {
  const auto trajectories = fileIn(parameters.trajectories, name + ".csv");
  const auto robot_series = fileIn(parameters.robot_series, name + ".csv");
  const auto robot_logs = fileIn(parameters.robot_logs, name + ".jsonl");
  if (trajectories) trajectories_.emplace(parameters.trajectories, name);
  if (robot_series) robot_series_.emplace(*robot_series, robotSeriesHeader());
  if (robot_logs) robot_logs_.emplace(*robot_logs, "");
}

void Recordings::finish() {
  const TickRecorder::Records records = recorder_->take();
  recorder_.reset();
  if (trajectories_) trajectories_->append(records.trajectory);
  if (robot_series_) robot_series_->append(records.robot_series);
  if (robot_logs_) robot_logs_->append(records.robot_log);
}

}  // namespace crowd
