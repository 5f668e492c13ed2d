#include "evaluation_output.h"

#include <map>

#include "common/files/files.h"
#include "common/text/quotes.h"
#include "simulation/evaluation/robot_record.h"
#include "simulation/evaluation/robot_series.h"
#include "simulation/evaluation/state_record.h"
#include "social_crowd/errors.h"
#include "training/record.h"

namespace crowd {
namespace {

/// What a function appends for an episode.
template <typename Append>
std::string rowsOf(const Append& append, const EvaluatedEpisode& walked) {
  std::string rows;
  append(walked.instance, walked.result, rows);
  return rows;
}

[[noreturn]] void throwSameOutput(const std::string& option, const std::string& one, const std::string& other) {
  throw InputError(option + ": " + one + " and " + other + " would both be written to files called '" + stemOf(one) +
                   "': rename one, or evaluate them one at a time into different folders");
}

/// Output files are named after the stems of the scenario files, so all stems must be different.
void requireOwnOutputs(const std::string& option, const std::string& folder,
                       const std::vector<std::string>& scenarios) {
  if (folder.empty()) return;
  std::map<std::string, std::string> file_of;
  for (const std::string& file : scenarios) {
    const auto [other, is_new] = file_of.emplace(stemOf(file), file);
    if (!is_new) throwSameOutput(option, other->second, file);
  }
}

/// Creates FOLDER/NAME.csv.
void openIn(const std::string& folder, const std::string& name, const std::string& header,
            std::optional<GrowingFile>& file) {
  if (folder.empty()) return;
  makeFolder(folder);
  file.emplace(folder + "/" + name + ".csv", header);
}

void openFile(const std::string& name, const std::string& header, std::optional<GrowingFile>& file) {
  if (!name.empty()) file.emplace(name, header);
}

void closeAll(const std::vector<std::optional<GrowingFile>*>& files) {
  for (std::optional<GrowingFile>* const file : files) {
    if (*file) (*file)->close();
  }
}

}  // namespace

void OutputNames::request(EvaluationPlan& plan) const {
  plan.record = !trajectories.empty();
  plan.scenes = scenes;
  plan.states = !states.empty();
  plan.robot_series = !robot_series.empty();
  plan.robot_log = !robot_log.empty();
}

void OutputNames::requireOwnFiles(const std::vector<std::string>& scenarios) const {
  // These files have the same names.
  std::map<std::string, std::string> option_of;
  for (const auto& [option, folder] : {std::pair<std::string, std::string>("--trajectories", trajectories),
                                       {"--states", states},
                                       {"--robot-series", robot_series}}) {
    if (folder.empty()) continue;
    const auto [other, is_new] = option_of.emplace(fullPath(folder), option);
    if (is_new) continue;
    throw InputError(option + ": expected another folder than that of " + other->second + ", got " + inQuotes(folder));
  }
  requireOwnOutputs("--trajectories", trajectories, scenarios);
  requireOwnOutputs("--scenes", scenes, scenarios);
  requireOwnOutputs("--states", states, scenarios);
  requireOwnOutputs("--robot-series", robot_series, scenarios);
}

ScenarioOutput::ScenarioOutput(const OutputNames& names, const std::string& scenario) {
  if (!names.trajectories.empty()) trajectories_.emplace(names.trajectories, scenario);
  openIn(names.states, scenario, STATE_RECORD_HEADER, states_);
  openIn(names.robot_series, scenario, robotSeriesHeader(), robot_series_);
  if (names.scenes.empty()) return;
  makeFolder(names.scenes);
  scenes_.emplace(names.scenes + "/" + scenario + ".yaml",
                  "# Drawn from " + scenario + ".yaml, one document per instance.\n");
}

void ScenarioOutput::append(const EvaluatedEpisode& walked) {
  if (trajectories_) trajectories_->append(walked.ticks.trajectory);
  if (states_) states_->append(walked.states);
  if (robot_series_) robot_series_->append(walked.ticks.robot_series);
  if (scenes_) scenes_->append(walked.scene);
}

void ScenarioOutput::close() {
  if (trajectories_) trajectories_->close();
  closeAll({&states_, &robot_series_, &scenes_});
}

void RunOutput::open(const OutputNames& names) {
  if (!names.csv.empty()) metrics_.emplace(names.csv);
  openFile(names.record, recordHeader(), agents_);
  openFile(names.robots_csv, robotRecordHeader(), robots_);
  openFile(names.robot_goals, robotGoalHeader(), robot_goals_);
  openFile(names.robot_log, "", robot_log_);
}

void RunOutput::append(const EvaluatedEpisode& walked) {
  if (agents_) agents_->append(rowsOf(appendRecordRows, walked));
  if (robots_) robots_->append(rowsOf(appendRobotRows, walked));
  if (robot_goals_) robot_goals_->append(rowsOf(appendRobotGoalRows, walked));
  if (robot_log_) robot_log_->append(walked.ticks.robot_log);
}

void RunOutput::finish(const std::string& csv) {
  if (metrics_) metrics_->write(csv);
  closeAll({&agents_, &robots_, &robot_goals_, &robot_log_});
}

}  // namespace crowd
