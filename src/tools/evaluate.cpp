// Evaluates a Q-table on scenario files, without ROS.

#include <iostream>
#include <optional>
#include <set>
#include <string>

#include "command_line.h"
#include "common/files/files.h"
#include "common/thread_pool.h"
#include "evaluation_output.h"
#include "learning/q_table_file.h"
#include "learning/q_table_names.h"
#include "metrics_table.h"
#include "rank_tools.h"
#include "ranks/distributed_evaluation.h"
#include "ranks/mpi_communicator.h"
#include "robot_metric_arguments.h"
#include "scenario/reading/scenario_files.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/evaluation/evaluation.h"
#include "simulation/evaluation/metrics.h"
#include "simulation/evaluation/robot_record.h"
#include "simulation/robot_controller.h"
#include "tools/terminal/progress_bar.h"
#include "training/training_config.h"
#include "web_server.h"

namespace crowd {
namespace {

constexpr std::uint64_t MOST_EPISODES = 1'000'000'000;  // for --first

struct Arguments {
  std::string q_table;
  std::string config;
  OutputNames output;
  std::vector<std::string> scenarios;
  EvaluationPlan plan;
  unsigned web_port = 8080;
};

/// Replaces the model of the table's header by that of a configuration.
void useModelOf(const std::string& config_file, const std::string& file, TrainedTable& trained) {
  const TrainingConfig config = readTrainingConfig(config_file, FileKinds::REGULAR_OR_PIPE);
  requireFit(config.model, trained.model, file);
  trained.model = config.model;
}

/// What there is to warn of: at the start of the first episode that has it, and after all episodes of a scenario.
struct WayWarnings {
  bool is_said = false;          // at the start of an episode
  std::size_t out_of_reach = 0;  // agents
  std::size_t without = 0;       // episodes
  std::string problem;           // of the first of these
};

void noteWays(const EpisodeResult& result, WayWarnings& ways) {
  ways.out_of_reach += result.outOfReach().size();
  if (result.way_finding_problem.empty()) return;
  if (ways.without++ == 0) ways.problem = result.way_finding_problem;
}

void printWarnings(const std::string& name, const WayWarnings& ways) {
  if (ways.out_of_reach > 0) std::cerr << name << ": " << outOfReachText(ways.out_of_reach) << "\n";
  if (ways.without > 0) {
    std::cerr << name << ": way-finding was left out in " << ways.without << " episode(s): " << ways.problem << "\n";
  }
}

Metrics evaluateFile(Communicator& ranks, const TrainedTable& trained, const Arguments& arguments,
                     const std::string& name, const ScenarioList& scenarios, RunOutput& output, bool& is_stopped) {
  std::optional<ScenarioOutput> own_output;
  if (ranks.rank() == 0) own_output.emplace(arguments.output, name);
  const std::uint64_t episodes = arguments.plan.episodes > 0 ? arguments.plan.episodes : scenarios.size();
  std::optional<ProgressBar> bar(std::in_place, name, episodes);
  Metrics metrics;
  WayWarnings ways;
  RobotSummary robots;
  EvaluationPlan plan = arguments.plan;
  plan.stop = StopRequest(isInterrupted);
  plan.warn = [&](std::uint64_t instance, const std::string& warning) {
    if (ways.is_said) return;
    ways.is_said = true;
    bar->clear();
    std::cerr << name << ": instance " << instance << ", at its start: " << warning << "\n";
  };
  const auto deliver = [&](EvaluatedEpisode& walked) {
    own_output->append(walked);
    output.append(walked);
    robots.add(walked.result);
    metrics.add(walked.result);
    noteWays(walked.result, ways);
    if (ranks.size() == 1 && metrics.episodes() < episodes) bar->show(metrics.episodes(), "");
    return !isInterrupted();
  };
  if (ranks.size() == 1) {
    is_stopped = !evaluate(trained, scenarios, plan, deliver);
  } else {
    is_stopped = !evaluateOnRanks(ranks, trained, scenarios, plan, observerOf(name, ranks, bar), deliver);
  }
  bar->clear();
  if (own_output) own_output->close();
  if (is_stopped && ranks.rank() == 0) {
    std::cerr << name << ": interrupted after " << metrics.episodes() << " of " << episodes
              << " episodes; the results are those of these, without unfinished ones\n";
  }
  printWarnings(name, ways);
  if (!robots.text().empty()) std::cerr << name << ": " << robots.text() << "\n";
  return metrics;
}

bool hasRobots(const ScenarioList& scenarios) {
  for (std::size_t i = 0; i < scenarios.size(); ++i) {
    if (!scenarios[i].robots.empty()) return true;
  }
  return false;
}

/// What the arguments name.
struct Inputs {
  TrainedTable trained;
  std::vector<ScenarioList> scenarios;
};

Inputs readInputs(Arguments& arguments) {
  arguments.q_table = findQTable(arguments.q_table);
  Inputs inputs{loadQTable(arguments.q_table, FileKinds::REGULAR_OR_PIPE), {}};
  if (!arguments.config.empty()) useModelOf(arguments.config, arguments.q_table, inputs.trained);
  arguments.output.request(arguments.plan);
  // All files are read before the first one is run, so that errors in any of them are reported at once.
  for (std::string& file : arguments.scenarios) {
    file = findScenario(file);
    inputs.scenarios.push_back(readScenarios(file, {}, FileKinds::REGULAR_OR_PIPE));
  }
  arguments.output.requireOwnFiles(arguments.scenarios);
  return inputs;
}

int evaluateAll(Communicator& ranks, Arguments& arguments) {
  std::optional<Inputs> inputs;
  RunOutput output;
  doOnAllRanks(ranks, [&] { inputs = readInputs(arguments); });
  if (ranks.size() > 1) requireSameRun(ranks, inputs->trained, arguments.scenarios, arguments.plan);
  const bool writes = ranks.rank() == 0;
  for (std::size_t i = 0; writes && i < inputs->scenarios.size(); ++i) {
    const ScenarioList& scenarios = inputs->scenarios[i];
    printReadingWarnings("evaluate", scenarios.warnings());
    if (arguments.plan.robot_controller != "none" && !hasRobots(scenarios)) {
      std::cerr << "evaluate: warning: " << arguments.scenarios[i] << " has no robot for --robot\n";
    }
  }
  doOnAllRanks(ranks, [&] {
    if (writes) output.open(arguments.output);
  });
  catchInterrupts();
  std::string csv = METRICS_CSV_HEADER;
  if (writes) printHeader();
  bool is_stopped = false;  // the same on all ranks
  for (std::size_t i = 0; i < inputs->scenarios.size() && !is_stopped; ++i) {
    const std::string name = stemOf(arguments.scenarios[i]);
    const Metrics metrics =
        evaluateFile(ranks, inputs->trained, arguments, name, inputs->scenarios[i], output, is_stopped);
    if (!writes) continue;
    printRow(name, metrics);
    csv += csvRow(name, metrics);
  }
  output.finish(csv);
  return is_stopped ? EXIT_INTERRUPTED : EXIT_FINE;
}

/// Checks the arguments of --web. @throws CLI::ValidationError
void checkWebArguments(const CLI::App& app, const Arguments& arguments) {
  const std::set<std::string> used{"--web", "--web-port", "--q-table", "--seed", "--threads", "SCENARIO"};
  for (const CLI::Option* const option : app.get_options()) {
    if (option->count() == 0 || used.count(option->get_name()) > 0) continue;
    throw CLI::ValidationError(option->get_name(), "is not used with --web");
  }
  if (arguments.scenarios.size() != 1) throw CLI::ValidationError("--web", "expected one SCENARIO");
}

/// Does not return, unless by an exception.
int showOne(const Arguments& arguments) {
  showInBrowser(findScenario(arguments.scenarios[0]), findQTable(arguments.q_table), arguments.plan.seed,
                arguments.plan.threads, arguments.web_port);
}

int runMain(int argc, char** argv) {
  CLI::App app("Runs scenarios with a Q-table (demo mode) and prints the metrics of the steering benchmark.",
               "evaluate");
  Arguments arguments;
  arguments.plan.threads = ThreadPool::countFor(0);
  app.add_option("--q-table", arguments.q_table, "Q-table file, or the name of a shipped one")->required();
  app.add_option("--config", arguments.config,
                 "training configuration whose model is used; default: that of the table");
  app.add_option("--episodes", arguments.plan.episodes,
                 "number of episodes of each scenario file; default: every document once")
      ->check(atLeast(1));
  app.add_option("--first", arguments.plan.first,
                 "number of the first episode; with --episodes 1 any episode is repeated alone")
      ->check(CLI::Range(std::uint64_t{0}, MOST_EPISODES))
      ->capture_default_str();
  app.add_option("--seed", arguments.plan.seed, "seed of random placements and random ties")
      ->check(atLeast(0))
      ->capture_default_str();
  const CLI::Option* const threads =
      app.add_option(
             "--threads", arguments.plan.threads,
             "number of threads; default: one per processor, with mpirun one per rank; results do not depend on it")
          ->check(CLI::Range(1, 1024));
  app.add_option("--trajectories", arguments.output.trajectories,
                 "folder for a file NAME.csv (instance,tick,agent,x,y) per scenario file");
  app.add_option("--scenes", arguments.output.scenes,
                 "folder for a file NAME.yaml per scenario file with the drawn scenes, one document per instance");
  app.add_option("--states", arguments.output.states,
                 "folder for a file NAME.csv per scenario file with the row of the Q-table, the action and the "
                 "occupied sectors of every decision");
  app.add_option("--record", arguments.output.record, "CSV file for the measures of every agent in every episode");
  app.add_option("--robot", arguments.plan.robot_controller,
                 "controller of the robots: none (they stand), straight (to their goals; they ignore people), reactive "
                 "(by their "
                 "laser scans alone), learned (by the Q-table, as the crowd), orca (by optimal reciprocal collision "
                 "avoidance), "
                 "or social_force (by the social force model)")
      ->check(CLI::IsMember(robotControllerNames()))
      ->capture_default_str();
  app.add_flag("--people-delay", arguments.plan.people_delay,
               "run each episode with robots again without them, and measure the people's delay and detour; episodes "
               "then last until the people have arrived");
  app.add_option("--robots-csv", arguments.output.robots_csv,
                 "CSV file for the measures of every robot in every episode");
  app.add_option("--robot-goals", arguments.output.robot_goals,
                 "CSV file for the measures of every goal of every robot in every episode");
  app.add_option("--robot-series", arguments.output.robot_series,
                 "folder for a file NAME.csv per scenario file with the measures of every robot in every tick");
  app.add_option(
      "--robot-log", arguments.output.robot_log,
      "file for the paths of robots and people, with goals and walls: lines of JSON (docs/metrics.md), which "
      "score_robots reads");
  addRobotMetricOptions(app, arguments.plan.robot_metrics);
  app.add_option("--csv", arguments.output.csv, "CSV file for the metrics");
  const CLI::Option* const web =
      app.add_flag("--web",
                   "show one scenario in a browser, until Ctrl-C (docs/web.md); with --q-table, --seed and --threads "
                   "only");
  app.add_option("--web-port", arguments.web_port, "of the server that shows it; 0: a free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  app.add_option("SCENARIO", arguments.scenarios, "scenario files, or names of scenarios of the package")->required();
  app.footer(
      std::string(
          "example:\n"
          "  rosrun social_crowd evaluate --q-table human --episodes 100 --csv metrics.csv circle6 "
          "place_corner\n"
          "  rosrun social_crowd evaluate --q-table human --web place_office\n\n"
          "success%: agents that arrived, of those that were to; contact%: whose bodies overlapped another one or a "
          "wall; collision%: that "
          "had "
          "one within their collision radius; clean%: episodes in which all arrived without contact.\n"
          "CSV files may be devices or pipes that are read from the start, such as /dev/stdout; the file of --csv "
          "keeps "
          "its contents until the metrics are complete.\n"
          "With MPI, several processes walk one crowd together, with the same results: mpirun -n 2 evaluate "
          "--q-table Q_TABLE SCENARIO (docs/mpi.md). One of them walks scenes with ways, robots or a population; "
          "without "
          "mpirun, all processors do. This program was built with") +
      (isBuiltWithMpi() ? "" : "out") +
      " MPI.\n"
      "Ctrl-C or SIGTERM end the run within a second: episodes that are not finished are left out of the results and "
      "files.\n"
      "Exit status: 0 success, 1 error in the input, 2 wrong usage, 130 interrupted.");
  app.final_callback([&] {
    if (web->count() > 0) checkWebArguments(app, arguments);
  });
  return runTool(app, argc, argv, [&](Communicator& ranks) {
    if (ranks.size() > 1 && threads->count() == 0) arguments.plan.threads = 1;
    if (web->count() > 0) return showOne(arguments);
    return evaluateAll(ranks, arguments);
  });
}

}  // namespace
}  // namespace crowd

int main(int argc, char** argv) { return crowd::runMain(argc, argv); }
