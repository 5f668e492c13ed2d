#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/files/growing_file.h"
#include "common/files/result_file.h"
#include "simulation/evaluation/evaluation.h"
#include "simulation/evaluation/trajectory.h"

namespace crowd {

/// @brief Files and folders that `evaluate` is to write; empty ones are not.
struct OutputNames {
  std::string trajectories;  ///< folders, with a file for each scenario
  std::string scenes;
  std::string states;
  std::string robot_series;
  std::string csv;  ///< files
  std::string record;
  std::string robots_csv;
  std::string robot_goals;
  std::string robot_log;

  /// @brief Makes a plan record what is to be written.
  void request(EvaluationPlan& plan) const;
  /// @brief Does nothing if all files of these scenarios are different ones. @throws InputError
  void requireOwnFiles(const std::vector<std::string>& scenarios) const;
};

/// @brief The requested files of one scenario.
class ScenarioOutput {
 public:
  /// @throws FileError
  ScenarioOutput(const OutputNames& names, const std::string& scenario);
  /// @brief Appends an episode. @throws FileError
  void append(const EvaluatedEpisode& walked);
  /// @brief Closes the files; once, after all episodes. @throws FileError
  void close();

 private:
  std::optional<TrajectoryFile> trajectories_;
  std::optional<GrowingFile> states_;
  std::optional<GrowingFile> robot_series_;
  std::optional<GrowingFile> scenes_;
};

/// @brief The requested files that hold all scenarios. None is open before open().
class RunOutput {
 public:
  /// @throws FileError
  void open(const OutputNames& names);
  /// @brief Appends an episode. @throws FileError
  void append(const EvaluatedEpisode& walked);
  /// @brief Writes the metrics of all scenarios and closes the other files; once. @throws FileError
  void finish(const std::string& csv);

 private:
  std::optional<ResultFile> metrics_;
  std::optional<GrowingFile> agents_;
  std::optional<GrowingFile> robots_;
  std::optional<GrowingFile> robot_goals_;
  std::optional<GrowingFile> robot_log_;
};

}  // namespace crowd
