// Trains a Q-table without ROS.

#include <string>

#include "command_line.h"
#include "common/text/yaml_reader.h"
#include "common/thread_pool.h"
#include "learning/model.h"
#include "learning/states/row_meaning.h"
#include "ranks/mpi_communicator.h"
#include "training_run.h"

namespace crowd {
namespace {

template <typename Types>
std::string rowsOf(const std::string& key, const Types& types) {
  std::string rows;
  for (const auto& type : types) {
    rows += "\n| `" + key + "` | `";
    rows.append(type.name).append("` | ").append(type.summary).append(" |");
  }
  return rows;
}

/// Returns the registered types of the parts of a model as a Markdown table.
std::string listOfTypes() {
  return "| key | `type` | contents |\n|---|---|---|" + rowsOf("state_set", stateSetTypes()) +
         rowsOf("action_set", actionSetTypes()) + rowsOf("reward", rewardTypes());
}

/// Returns what the rows of a state set mean, as YAML. @param text the state set, as in a configuration
std::string meaningOfRows(const std::string& text) {
  const std::vector<YAML::Node> documents = parseYamlStream(text, "state_set");
  if (documents.size() != 1) throw InputError("state_set: expected a map such as {type: occupancy}");
  // The names do not depend on the action set.
  const auto actions = makeActionSet(YAML::Load("{type: kings_moves}"), {"action_set", 0, ""});
  const auto states = makeStateSet(documents.front(), {"state_set", 0, ""}, *actions);
  const auto* const rows = dynamic_cast<const ExplainedRows*>(states.get());
  if (rows == nullptr) throw InputError("state_set: its rows have no description");
  return rows->meaning().text();
}

void describeRows(const std::string& state_set) {
  std::string text;
  try {
    text = meaningOfRows(state_set);
  } catch (const InputError& error) {
    throw CLI::ValidationError("--describe-rows", error.what());
  }
  throw CLI::CallForVersion(text, 0);
}

void addFileOptions(CLI::App& app, TrainingArguments& arguments) {
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
  TrainingArguments arguments;
  arguments.threads = ThreadPool::countFor(0);
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
  app.add_option("--q-table", arguments.q_table,
                 "Q-table file, or the name of a shipped one, from which learning continues");
  app.add_option("--tables", arguments.tables,
                 "one shared table, or one own table per agent; overrides the configuration")
      ->check(CLI::IsMember({"shared", "own"}));
  const CLI::Option* const threads =
      app.add_option(
             "--threads", arguments.threads,
             "number of threads for learners side by side; default: one per processor, with mpirun one per rank; "
             "results do not depend on it")
          ->check(CLI::Range(1, 1024));
  app.add_flag_callback(
      "--list-types", [] { throw CLI::CallForVersion(listOfTypes(), 0); },
      "print the types of state sets, action sets and rewards that a configuration can use");
  app.add_option_function<std::string>("--describe-rows", describeRows,
                                       "print what the rows of a Q-table with this state set mean, as YAML")
      ->type_name("STATE_SET");
  addFileOptions(app, arguments);
  app.footer(
      std::string(
          "example:\n"
          "  rosrun social_crowd train anticipation.yaml --output table.txt --log learning.csv --plot \\\n"
          "      --checkpoint table.checkpoint --resume\n\n"
          "Ctrl-C ends the training after the present turn and saves the values learned so far. With --checkpoint and "
          "--resume, the same command goes on after Ctrl-C, a crash or kill -9, and table, record and log become the "
          "same bytes as without the interruption. OUTPUT keeps its contents until the new ones are complete; space "
          "for "
          "them is kept free from the start. If another file cannot be written any more, such as on a full disk, the "
          "training ends, and OUTPUT has what was learned; if only the checkpoint cannot, the training goes on. "
          "OUTPUT, record and log may be devices or pipes that are read from the start; what is no regular file is "
          "never replaced.\n"
          "With MPI, the learners side by side of a configuration are divided among several processes, with the same "
          "results: mpirun -n 2 train CONFIG --output TABLE (docs/mpi.md says how long mpirun waits "
          "after Ctrl-C). This program was built with") +
      (isBuiltWithMpi() ? "" : "out") +
      " MPI.\n"
      "Exit status: 0 success, 1 error in the input or with a file, 2 wrong usage, 130 interrupted.");
  return runTool(app, argc, argv, [&](Communicator& ranks) {
    if (ranks.size() > 1 && threads->count() == 0) arguments.threads = 1;
    return train(ranks, arguments);
  });
}

}  // namespace
}  // namespace crowd

int main(int argc, char** argv) { return crowd::runMain(argc, argv); }
