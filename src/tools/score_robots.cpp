// Computes the metrics of robots from logs of poses, without ROS.

#include <cmath>
#include <iostream>
#include <optional>

#include "command_line.h"
#include "common/files/result_file.h"
#include "common/text/numbers.h"
#include "robot_means.h"
#include "robot_metric_arguments.h"
#include "robots/log/robot_log_scoring.h"
#include "simulation/evaluation/robot_record.h"
#include "simulation/evaluation/robot_series.h"

namespace crowd {
namespace {

struct Arguments {
  std::vector<std::string> logs;
  std::string csv;
  std::string goals;
  std::string series;
  bool lists_fields = false;
  RobotMetricOptions metrics;
};

/// Prints name and unit of all columns of --csv.
int printFields() {
  std::cout << "name,unit\n";
  const RobotResult result;
  RobotResult::visitFields(
      [](const MetricName& metric, const auto& /*value*/) { std::cout << metric.name << "," << metric.unit << "\n"; },
      result);
  return EXIT_FINE;
}

/// Prints the numbers of a robot that were measured, one a line.
void print(const EpisodeResult& episode, std::uint64_t number, const RobotResult& robot) {
  std::cout << episode.scenario << ", episode " << number << ", robot " << robot.name << "\n";
  RobotResult::visitMeasures(
      [](const MetricName& metric, const auto& value) {
        if (std::isnan(static_cast<double>(value))) return;
        std::cout << measureLine(metric, toField(value), metric.unit);
      },
      robot);
}

/// What is written at the end.
struct Output {
  std::string robots = robotRecordHeader();
  std::string goals = robotGoalHeader();
  std::string series = robotSeriesHeader();
};

int scoreAll(const Arguments& arguments) {
  const auto open = [](const std::string& name) {
    return name.empty() ? std::nullopt : std::make_optional<ResultFile>(name);
  };
  std::optional<ResultFile> csv = open(arguments.csv);
  std::optional<ResultFile> goals = open(arguments.goals);
  std::optional<ResultFile> series = open(arguments.series);
  Output output;
  RobotMeans means;
  LogScoring scoring;
  if (series) {
    scoring.on_tick = [&](const RobotLogReplay& replay) {
      const double time = static_cast<double>(replay.tick()) * replay.header().tick_duration;
      appendRobotSeries(replay.header().episode, replay.tick(), time, replay.monitor(), output.series);
    };
  }
  scoring.on_episode = [&](const RobotLogReplay& replay) {
    EpisodeResult episode;
    episode.scenario = replay.header().scenario;
    episode.ticks = replay.tick();
    episode.robots = replay.results();
    const std::uint64_t number = replay.header().episode;
    appendRobotRows(number, episode, output.robots);
    appendRobotGoalRows(number, episode, output.goals);
    if (csv && csv->isStream()) return;
    for (const RobotResult& robot : episode.robots) {
      print(episode, number, robot);
      means.add(robot);
    }
  };
  for (const std::string& log : arguments.logs) {
    scoreRobotLog(log, arguments.metrics, scoring, FileKinds::REGULAR_OR_PIPE);
  }
  std::cout << means.text();
  if (csv) csv->write(output.robots);
  if (goals) goals->write(output.goals);
  if (series) series->write(output.series);
  return EXIT_FINE;
}

int runMain(int argc, char** argv) {
  CLI::App app("Computes the metrics of robots from logs of poses, as `evaluate` does for its episodes.",
               "score_robots");
  Arguments arguments;
  CLI::Option* const logs = app.add_option("LOG", arguments.logs,
                                           "logs of robots: lines of JSON, as of `evaluate --robot-log` "
                                           "(docs/metrics.md), or made by hand");
  app.add_option("--csv", arguments.csv, "CSV file for the metrics, with the columns of `evaluate --robots-csv`");
  app.add_option("--goals", arguments.goals, "CSV file for the metrics of each goal");
  app.add_option("--series", arguments.series, "CSV file for the measures of each robot in each tick");
  addRobotMetricOptions(app, arguments.metrics);
  app.add_flag("--fields", arguments.lists_fields, "print names and units of the columns of --csv, and nothing else");
  app.footer(
      "example:\n"
      "  rosrun social_crowd evaluate --q-table anticipation --robot reactive --robot-log "
      "log.jsonl "
      "robot_hall\n"
      "  rosrun social_crowd score_robots log.jsonl --csv robots.csv\n\n"
      "Prints the metrics that were measured of each robot, and their means over all robots and episodes, unless the "
      "CSV file is a device or a pipe, such as "
      "/dev/stdout. Files are written when all logs have been read.\n"
      "Exit status: 0 success, 1 error in the input, 2 wrong usage.");
  return runTool(app, argc, argv, [&](Communicator& /*ranks*/) {
    if (arguments.lists_fields) return printFields();
    if (logs->count() > 0) return scoreAll(arguments);
    std::cerr << "score_robots: expected a LOG\nRun with --help for more information.\n";
    return static_cast<int>(EXIT_BAD_USAGE);
  });
}

}  // namespace
}  // namespace crowd

int main(int argc, char** argv) { return crowd::runMain(argc, argv); }
