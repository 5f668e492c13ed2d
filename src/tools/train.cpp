// Trains a Q-table without ROS.

#include <algorithm>
#include <deque>
#include <filesystem>
#include <iostream>
#include <optional>
#include <thread>

#include "command_line.h"
#include "progress_bar.h"
#include "social_crowd/common/files.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/simulation/record.h"
#include "social_crowd/simulation/training.h"
#include "social_crowd/simulation/training_config.h"

namespace crowd {
namespace {

struct Arguments {
  std::string config;
  std::string output;
  std::string q_table;
  std::string record;
  std::string tables;
  std::optional<std::uint64_t> episodes;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> save_every;
  unsigned threads = 1;
};

/// Success and contact rates of the last episodes [% of the agents].
class RecentRates {
 public:
  void add(const EpisodeResult& result) {
    results_.push_back({result.agentCount(), result.arrivedCount(), result.touchedCount()});
    if (results_.size() > WINDOW) results_.pop_front();
  }

  std::string text() const {
    Counts sum;
    for (const Counts& counts : results_) {
      sum.agents += counts.agents;
      sum.arrived += counts.arrived;
      sum.touched += counts.touched;
    }
    const double whole = sum.agents > 0 ? static_cast<double>(sum.agents) : 1.0;
    return "success " + toFixedText(100.0 * static_cast<double>(sum.arrived) / whole, 1, 5) + " %  contact " +
           toFixedText(100.0 * static_cast<double>(sum.touched) / whole, 1, 5) + " %";
  }

 private:
  static constexpr std::size_t WINDOW = 200;  // episodes
  struct Counts {
    std::size_t agents = 0;
    std::size_t arrived = 0;
    std::size_t touched = 0;
  };
  std::deque<Counts> results_;
};

TrainingConfig readConfigFor(const Arguments& arguments) {
  TrainingConfig config = readTrainingConfig(arguments.config);
  if (arguments.episodes) config.training.episodes = *arguments.episodes;
  if (arguments.seed) config.training.seed = *arguments.seed;
  if (arguments.save_every) config.training.save_every = *arguments.save_every;
  if (!arguments.tables.empty()) config.training.tables = TABLE_USES.parse(arguments.tables);
  return config;
}

Training beginTraining(const Arguments& arguments) {
  TrainingConfig config = readConfigFor(arguments);
  if (arguments.q_table.empty()) return Training(std::move(config), arguments.threads);
  TrainedTable begin = loadQTable(arguments.q_table);
  requireFit(config.model, begin.model, arguments.q_table);
  return Training(std::move(config), std::move(begin), arguments.threads);
}

std::string recordRows(std::uint64_t episode, const EpisodeResult& result) {
  std::string rows;
  appendRecordRows(episode, result, rows);
  return rows;
}

/// The name of the table after a number of episodes: TABLE.txt -> TABLE_000500.txt.
std::string nameAfter(const std::string& output, std::uint64_t episode) {
  const std::filesystem::path path(output);
  const std::string name = path.stem().string() + "_" + toPaddedText(episode, 6) + path.extension().string();
  return (path.parent_path() / name).string();
}

int train(const Arguments& arguments) {
  Training training = beginTraining(arguments);
  saveQTable(arguments.output, training.trained());  // reports a file that cannot be written before the training
  std::optional<GrowingFile> record;
  if (!arguments.record.empty()) record.emplace(arguments.record, RECORD_HEADER);
  const TrainingPlan& plan = training.config().training;
  ProgressBar bar("episode", plan.episodes);
  RecentRates rates;
  const auto note = [&] {
    return rates.text() + "  " + formatCount(static_cast<double>(training.decisions()) / bar.seconds()) +
           " decisions/s";
  };
  catchInterrupts();
  while (!training.isDone() && !isInterrupted()) {
    const std::uint64_t before = training.episode();
    std::uint64_t episode = before;
    for (const EpisodeResult& result : training.runNextTurn()) {
      rates.add(result);
      if (record) record->append(recordRows(episode++, result));
    }
    if (plan.save_every > 0 && training.episode() / plan.save_every > before / plan.save_every) {
      saveQTable(nameAfter(arguments.output, training.episode()), training.trained());
    }
    if (bar.isDue(training.episode()) && !training.isDone()) bar.show(training.episode(), note());
  }
  bar.finish(training.episode(), note());
  const TrainedTable trained = training.trained();
  saveQTable(arguments.output, trained);
  std::cout << arguments.output << ": " << training.episode() << " episodes, " << trained.decisions << " decisions, "
            << trained.table.visitedRows() << " of " << trained.table.rows() << " rows visited, took "
            << formatDuration(bar.seconds()) << (isInterrupted() ? "; interrupted" : "") << std::endl;
  return isInterrupted() ? EXIT_INTERRUPTED : EXIT_FINE;
}

template <typename Types>
void printTypes(const char* key, const Types& types) {
  for (const auto& type : types) std::cout << "| `" << key << "` | `" << type.name << "` | " << type.summary << " |\n";
}

/// Prints the registered types of the parts of a model as a Markdown table.
void listTypes() {
  std::cout << "| key | `type` | contents |\n|---|---|---|\n";
  printTypes("state_set", stateSetTypes());
  printTypes("action_set", actionSetTypes());
  printTypes("reward", rewardTypes());
  std::cout.flush();
}

int runMain(int argc, char** argv) {
  CLI::App app("Trains a Q-table: one or more agents learn to walk in the scenarios of CONFIG.", "train");
  Arguments arguments;
  arguments.threads = std::max(1U, std::thread::hardware_concurrency());
  app.add_option("CONFIG", arguments.config, "training configuration, such as config/learning/thesis_nearest.yaml")
      ->required();
  app.add_option("--output,-o", arguments.output, "Q-table file to write")->required();
  app.add_option("--episodes", arguments.episodes, "number of episodes; overrides the configuration")
      ->check(atLeast(1));
  app.add_option("--seed", arguments.seed, "seed of all random numbers; overrides the configuration")
      ->check(atLeast(0));
  app.add_option("--save-every", arguments.save_every,
                 "interval in episodes at which the table is also saved, as OUTPUT_000500.txt etc.; 0: never; "
                 "overrides the configuration")
      ->check(atLeast(0));
  app.add_option("--q-table", arguments.q_table, "Q-table file from which learning continues");
  app.add_option("--tables", arguments.tables,
                 "one shared table, or one own table per agent; overrides the configuration")
      ->check(CLI::IsMember({"shared", "own"}));
  app.add_option("--threads", arguments.threads,
                 "number of threads for learners side by side; default: one per processor; results do not depend on it")
      ->check(CLI::Range(1, 1024));
  app.add_flag_callback(
      "--list-types",
      [] {
        listTypes();
        throw CLI::Success();
      },
      "print the types of state sets, action sets and rewards that a configuration can use");
  app.add_option("--record", arguments.record, "CSV file for the measures of every agent in every episode");
  app.footer(
      "Ctrl-C ends the training and saves the values learned so far.\n"
      "Exit status: 0 success, 1 error in the input, 2 wrong usage, 130 interrupted.");
  return runTool(app, argc, argv, [&] { return train(arguments); });
}

}  // namespace
}  // namespace crowd

int main(int argc, char** argv) { return crowd::runMain(argc, argv); }
