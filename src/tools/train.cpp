// Trains a Q-table without ROS.

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "command_line.h"
#include "social_crowd/common/errors.h"
#include "social_crowd/common/file_lock.h"
#include "social_crowd/common/files.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/learning/q_table_file.h"
#include "social_crowd/simulation/training.h"
#include "social_crowd/simulation/training_config.h"
#include "terminal.h"
#include "training_checks.h"
#include "training_display.h"
#include "training_files.h"

namespace crowd {
namespace {

struct Arguments {
  std::string config;
  std::string output;
  std::string q_table;
  std::string tables;
  TrainingFileNames files;
  double checkpoint_interval = 10.0;  // [s]
  bool resume = false;
  bool plot = false;
  std::optional<std::uint64_t> episodes;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> save_every;
  unsigned threads = 1;
};

TrainingConfig readConfigFor(const Arguments& arguments) {
  TrainingConfig config = readTrainingConfig(arguments.config);
  if (arguments.episodes) config.training.episodes = *arguments.episodes;
  if (arguments.seed) config.training.seed = *arguments.seed;
  if (arguments.save_every) config.training.save_every = *arguments.save_every;
  if (!arguments.tables.empty()) config.training.tables = TABLE_USES.parse(arguments.tables);
  return config;
}

/// Whether the training resumes from its checkpoint. A checkpoint is never overwritten by a training that begins anew,
/// and nothing that was learned by one that was to be resumed.
bool resumes(const Arguments& arguments) {
  const std::string& checkpoint = arguments.files.checkpoint;
  if (checkpoint.empty()) return false;
  if (std::filesystem::exists(checkpoint)) {
    if (arguments.resume) return true;
    throw InputError(checkpoint + ": there is a checkpoint already: go on from it with --resume, or remove it");
  }
  if (arguments.resume) requireNothingLost(arguments.output, arguments.files, arguments.q_table);
  return false;
}

Training makeTraining(const Arguments& arguments, bool resumes) {
  TrainingConfig config = readConfigFor(arguments);
  if (resumes || arguments.q_table.empty()) return Training(std::move(config), arguments.threads);
  TrainedTable begin = loadQTable(arguments.q_table);
  requireFit(config.model, begin.model, arguments.q_table);
  return Training(std::move(config), std::move(begin), arguments.threads);
}

/// The table from which the training began is only named: it may have been replaced by the table of the training.
std::string identityFor(const Arguments& arguments, const Training& training) {
  if (arguments.files.checkpoint.empty()) return "";
  return identityOf(training) + (arguments.q_table.empty() ? "" : "q_table: " + arguments.q_table + "\n");
}

/// Restores the training from its checkpoint. Returns the sizes of its files.
std::map<std::string, std::uint64_t> restoreCheckpoint(const Arguments& arguments, const std::string& identity,
                                                       Training& training) {
  Checkpoint checkpoint = readCheckpoint(arguments.files, identity, training.config().model);
  training.restore(std::move(checkpoint.state));
  removeTemporaries(arguments.files.checkpoint);
  std::cerr << arguments.files.checkpoint << ": " << training.episode() << " of " << training.config().training.episodes
            << " episodes are done" << std::endl;
  return std::move(checkpoint.sizes);
}

/// The name of the table after a number of episodes: TABLE.txt -> TABLE_000500.txt.
std::string nameAfter(const std::string& output, std::uint64_t episode) {
  const std::filesystem::path path(output);
  const std::string name = path.stem().string() + "_" + toPaddedText(episode, 6) + path.extension().string();
  return (path.parent_path() / name).string();
}

/// Saves the table. @param resumed whether an earlier run may have been killed while it saved the same one
void save(const std::string& file, const TrainedTable& trained, bool resumed) {
  if (resumed) removeTemporaries(file);
  saveQTable(file, trained);
}

/// Runs the episodes until all are done or Ctrl-C is pressed. Without checkpoints it can go on, so that their first
/// error is only printed. @throws FileError if another file cannot be written
void runEpisodes(const Arguments& arguments, bool resumed, Training& training, TrainingFiles& files,
                 TrainingDisplay& display) {
  const std::uint64_t save_every = training.config().training.save_every;
  bool has_warned = false;
  while (!training.isDone() && !isInterrupted()) {
    const std::uint64_t before = training.episode();
    const std::vector<LearnedEpisode> episodes = training.runNextTurn();
    files.append(before, episodes);
    for (const LearnedEpisode& episode : episodes) display.add(episode);
    if (save_every > 0 && training.episode() / save_every > before / save_every) {
      save(nameAfter(arguments.output, training.episode()), training.trained(), resumed);
    }
    try {
      files.saveCheckpointIfDue(training);
    } catch (const FileError& error) {
      if (!has_warned) std::cerr << "\ntrain: " << error.what() << "; the training goes on" << std::endl;
      has_warned = true;
    }
    display.show();
  }
}

/// Runs the episodes, then saves checkpoint and table. The table is saved whatever happens to the other files.
/// Returns the first error of another file; empty: none. @throws FileError if the table cannot be saved
std::string runAndSave(const Arguments& arguments, bool resumed, Training& training, TrainingFiles& files,
                       TrainingDisplay& display) {
  std::string problem;
  try {
    runEpisodes(arguments, resumed, training, files, display);
    files.saveCheckpoint(training);
  } catch (const FileError& error) {
    problem = error.what();
  }
  saveQTable(arguments.output, training.trained());
  return problem;
}

/// Prints what became of the training. @param ending why it ended; empty: all episodes are done
void printSummary(const Arguments& arguments, const Training& training, double seconds, const std::string& ending) {
  const TrainedTable trained = training.trained();
  std::cout << arguments.output << ": " << training.episode() << " episodes, " << trained.decisions << " decisions, "
            << trained.table.visitedRows() << " of " << trained.table.rows() << " rows visited, took "
            << formatDuration(seconds) << (ending.empty() ? "" : "; ") << ending << std::endl;
}

int train(const Arguments& arguments) {
  if (arguments.plot && !isTerminal()) {
    std::cerr << "train: --plot: standard error is no terminal; for a plot of a training in the background, write a "
                 "--log and draw it with plot_learning\nRun with --help for more information."
              << std::endl;
    return EXIT_BAD_USAGE;
  }
  requireWritable(arguments.output, arguments.files);
  std::optional<FileLock> lock;
  if (!arguments.files.checkpoint.empty()) lock.emplace(arguments.files.checkpoint);
  const bool resumed = resumes(arguments);
  Training training = makeTraining(arguments, resumed);
  const std::string identity = identityFor(arguments, training);
  std::map<std::string, std::uint64_t> sizes;
  if (resumed) sizes = restoreCheckpoint(arguments, identity, training);
  TrainingFiles files(arguments.files, identity, arguments.checkpoint_interval, resumed ? &sizes : nullptr);
  if (!resumed) files.saveCheckpoint(training);
  // After the first checkpoint: if the training is killed between the two, it can still be resumed.
  save(arguments.output, training.trained(), resumed);
  if (arguments.plot || !arguments.files.log.empty()) training.countVisitedRows();
  const bool was_done = training.isDone();
  const bool plots_log = arguments.plot && !arguments.files.log.empty();
  TrainingDisplay display(training, arguments.plot, plots_log ? readFile(arguments.files.log) : "");
  catchInterrupts();
  const std::string problem = runAndSave(arguments, resumed, training, files, display);
  if (!was_done) display.finish();
  const bool failed = !problem.empty();
  printSummary(arguments, training, display.seconds(),
               failed            ? "ended by an error"
               : was_done        ? "was complete"
               : isInterrupted() ? "interrupted"
                                 : "");
  if (failed) throw FileError(problem);
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

void addFileOptions(CLI::App& app, Arguments& arguments) {
  app.add_option("--record", arguments.files.record, "CSV file for the measures of every agent in every episode");
  app.add_option("--log", arguments.files.log,
                 "CSV file with a row for every episode: success, contact, collision, mean reward, visited rows, "
                 "epsilon and decisions");
  CLI::Option* const checkpoint =
      app.add_option("--checkpoint", arguments.files.checkpoint, "file from which an interrupted training can go on");
  app.add_option("--checkpoint-interval", arguments.checkpoint_interval,
                 "time between two checkpoints [s]; 0: one after each turn")
      ->check(CLI::Range(0.0, 1e6))
      ->needs(checkpoint)
      ->capture_default_str();
  app.add_flag("--resume", arguments.resume, "go on from the checkpoint; without one, begin if nothing learned is lost")
      ->needs(checkpoint);
  app.add_flag("--plot", arguments.plot,
               "plot success, contact, mean reward, visited rows and epsilon in the terminal while it learns");
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
  addFileOptions(app, arguments);
  app.footer(
      "example:\n"
      "  rosrun social_crowd train anticipation.yaml --output table.txt --log learning.csv --plot \\\n"
      "      --checkpoint table.checkpoint --resume\n\n"
      "Ctrl-C ends the training and saves the values learned so far. With --checkpoint and --resume, the same command "
      "goes on after Ctrl-C, a crash or kill -9, and table, record and log become the same bytes as without the "
      "interruption. If a file cannot be written any more, such as on a full disk, the training ends, and OUTPUT has "
      "what "
      "was learned; if only the checkpoint cannot, the training goes on.\n"
      "Exit status: 0 success, 1 error in the input or with a file, 2 wrong usage, 130 interrupted.");
  return runTool(app, argc, argv, [&] { return train(arguments); });
}

}  // namespace
}  // namespace crowd

int main(int argc, char** argv) { return crowd::runMain(argc, argv); }
