#include "training_run.h"

#include <csignal>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <utility>
#include <vector>

#include "command_line.h"
#include "common/files/file_lock.h"
#include "common/files/files.h"
#include "common/files/result_file.h"
#include "common/text/numbers.h"
#include "learning/q_table_file.h"
#include "learning/q_table_names.h"
#include "rank_tools.h"
#include "social_crowd/errors.h"
#include "tools/terminal/terminal.h"
#include "tools/terminal/training_display.h"
#include "training/training.h"
#include "training/training_config.h"
#include "training_checks.h"

namespace crowd {
namespace {

TrainingConfig readConfigFor(const TrainingArguments& arguments) {
  TrainingConfig config = readTrainingConfig(arguments.config, FileKinds::REGULAR_OR_PIPE);
  if (arguments.episodes) config.training.episodes = *arguments.episodes;
  if (arguments.seed) config.training.seed = *arguments.seed;
  if (arguments.save_every) config.training.save_every = *arguments.save_every;
  if (!arguments.tables.empty()) config.training.tables = TABLE_USES.parse(arguments.tables);
  return config;
}

/// Whether the training resumes from its checkpoint. A checkpoint is never overwritten by a training that begins anew,
/// and nothing that was learned by one that was to be resumed.
bool resumes(const TrainingArguments& arguments) {
  const std::string& checkpoint = arguments.files.checkpoint;
  if (checkpoint.empty()) return false;
  if (std::filesystem::exists(checkpoint)) {
    if (arguments.resume) return true;
    throw InputError(checkpoint + ": there is a checkpoint already: go on from it with --resume, or remove it");
  }
  if (arguments.resume) requireNothingLost(arguments.output, arguments.files, arguments.q_table);
  return false;
}

/// The table from which the training began is only named: it may have been replaced by the table of the training.
std::string identityFor(const TrainingArguments& arguments, const Training& training) {
  if (arguments.files.checkpoint.empty()) return "";
  return identityOf(training) + (arguments.q_table.empty() ? "" : "q_table: " + arguments.q_table + "\n");
}

/// What a training goes on from, the same on all ranks.
struct Beginning {
  bool resumed = false;
  std::string checkpoint;  // contents of its file
  std::optional<TrainedTable> q_table;
};

/// What rank 0 has from the start.
struct FirstFiles {
  std::optional<ResultFile> output;
  std::optional<FileLock> lock;  // of the checkpoint
};

/// Locks and reads the checkpoint on rank 0, after a look at all files that are to be written, and shares its contents.
Beginning readBeginning(Communicator& ranks, const TrainingArguments& arguments, FirstFiles& files) {
  Communicator::Bytes contents;  // empty: the training begins anew
  doOnAllRanks(ranks, [&] {
    if (ranks.rank() != 0) return;
    requireWritable(arguments.output, arguments.files);
    files.output.emplace(arguments.output);
    if (!arguments.files.checkpoint.empty()) files.lock.emplace(arguments.files.checkpoint);
    if (!resumes(arguments)) return;
    const std::string text = "\n" + readFile(arguments.files.checkpoint);  // the file may be empty
    contents.assign(text.begin(), text.end());
  });
  ranks.broadcast(contents);
  Beginning beginning;
  beginning.resumed = !contents.empty();
  if (beginning.resumed) beginning.checkpoint.assign(contents.begin() + 1, contents.end());
  return beginning;
}

/// Restores the training from its checkpoint. Returns the sizes of its files.
std::map<std::string, std::uint64_t> restoreCheckpoint(Communicator& ranks, const TrainingArguments& arguments,
                                                       const std::string& text, const std::string& identity,
                                                       Training& training) {
  Checkpoint checkpoint = parseCheckpoint(text, arguments.files.checkpoint, identity, training.config().model);
  if (ranks.rank() == 0) requireContinuable(arguments.files, checkpoint);
  training.restore(std::move(checkpoint.state));
  return std::move(checkpoint.sizes);
}

/// The name of the table after a number of episodes: TABLE.txt -> TABLE_000500.txt.
std::string nameAfter(const std::string& output, std::uint64_t episode) {
  const std::filesystem::path path(output);
  const std::string name = path.stem().string() + "_" + toPaddedText(episode, 6) + path.extension().string();
  return (path.parent_path() / name).string();
}

/// A training with its files and its display, which only rank 0 has.
class TrainingRun {
 public:
  TrainingRun(Communicator& ranks, const TrainingArguments& arguments) : ranks_(ranks), arguments_(arguments) {}

  /// Reads everything, then writes the first files.
  void begin();
  /// Runs the episodes, then saves checkpoint and table. Returns the exit status. @throws FileError on rank 0 if the
  /// table cannot be saved
  int run();

 private:
  bool isFirstRank() const { return ranks_.rank() == 0; }
  void makeTraining();
  void restore();
  void openFiles();
  void noteProblemOf(const std::function<void()>& write);
  void runTurns();
  void deliver(std::uint64_t before, const std::vector<LearnedEpisode>& episodes);
  void shareEnding();
  void printSummary(bool was_done);

  Communicator& ranks_;
  const TrainingArguments& arguments_;
  FirstFiles first_files_;
  Beginning beginning_;
  std::optional<Training> training_;
  std::string identity_;
  std::map<std::string, std::uint64_t> sizes_;
  std::optional<TrainingFiles> files_;
  std::optional<TrainingDisplay> display_;
  bool has_warned_ = false;
  std::string problem_;          // the first error of a file but the table; on rank 0
  bool has_failed_ = false;      // on rank 0; the same on all ranks after shareEnding()
  bool is_interrupted_ = false;  // a rank, the same on all ranks
};

void TrainingRun::begin() {
  beginning_ = readBeginning(ranks_, arguments_, first_files_);
  doOnAllRanks(ranks_, [&] { makeTraining(); });
  if (isFirstRank()) printReadingWarnings("train", training_->scenarios().warnings());
  const bool counts_rows = arguments_.plot || !arguments_.files.log.empty();
  if (ranks_.size() > 1) {
    requireSameTraining(ranks_, *training_, beginning_.q_table ? &*beginning_.q_table : nullptr, counts_rows);
  }
  beginning_.q_table.reset();
  if (beginning_.resumed) doOnAllRanks(ranks_, [&] { restore(); });
  doOnAllRanks(ranks_, [&] { openFiles(); });
  if (counts_rows) training_->countVisitedRows();
}

void TrainingRun::makeTraining() {
  TrainingConfig config = readConfigFor(arguments_);
  if (beginning_.resumed || arguments_.q_table.empty()) {
    training_.emplace(std::move(config), arguments_.threads, ranks_);
  } else {
    beginning_.q_table = loadQTable(findQTable(arguments_.q_table), FileKinds::REGULAR_OR_PIPE);
    requireFit(config.model, beginning_.q_table->model, arguments_.q_table);
    training_.emplace(std::move(config), *beginning_.q_table, arguments_.threads, ranks_);
  }
  identity_ = identityFor(arguments_, *training_);
}

void TrainingRun::restore() {
  const std::string& file = arguments_.files.checkpoint;
  sizes_ = restoreCheckpoint(ranks_, arguments_, beginning_.checkpoint, identity_, *training_);
  beginning_.checkpoint.clear();
  if (!isFirstRank()) return;
  std::cerr << file << ": " << training_->episode() << " of " << training_->config().training.episodes
            << " episodes are done" << std::endl;
}

void TrainingRun::openFiles() {
  if (!isFirstRank()) return;
  const bool resumed = beginning_.resumed;
  if (first_files_.output->isStream() && training_->config().training.save_every > 0) {
    throw InputError("--output: expected a regular file, as the tables of save_every are written beside it, got '" +
                     arguments_.output + "'; --save-every 0 writes none");
  }
  // A record or a log that fills the disk leaves space for the table.
  first_files_.output->reserve(maxTextSize(training_->trained()));
  files_.emplace(arguments_.files, identity_, arguments_.checkpoint_interval, resumed ? &sizes_ : nullptr);
  if (!resumed) files_->saveCheckpoint(*training_);
  const bool plots_log = resumed && arguments_.plot && !arguments_.files.log.empty();
  display_.emplace(*training_, arguments_.plot, plots_log ? readFile(arguments_.files.log) : "");
}

int TrainingRun::run() {
  const bool was_done = training_->isDone();
  catchInterrupts();
  runTurns();
  if (isFirstRank()) {
    if (!has_failed_) noteProblemOf([&] { files_->saveCheckpoint(*training_); });
    noteProblemOf([&] { files_->close(); });
    // Whatever happens to the other files.
    noteProblemOf([&] { first_files_.output->write(toText(training_->trained())); });
  }
  shareEnding();
  const std::string times = ranks_.size() > 1 ? training_->report().text() : "";
  if (isFirstRank()) {
    if (!was_done) display_->finish();
    if (!was_done && !times.empty()) std::cerr << arguments_.output << ": " << times << std::endl;
    printSummary(was_done);
    if (has_failed_) std::cerr << "train: " << problem_ << std::endl;
  }
  if (has_failed_) return EXIT_BAD_INPUT;
  return is_interrupted_ ? EXIT_INTERRUPTED : EXIT_FINE;
}

/// Writes files. If one cannot be written, all ranks end after the next shareEnding().
void TrainingRun::noteProblemOf(const std::function<void()>& write) {
  try {
    write();
  } catch (const FileError& error) {
    problem_ += (problem_.empty() ? "" : "; ") + std::string(error.what());
    has_failed_ = true;
  }
}

/// Runs turns until all episodes are done, Ctrl-C is pressed, or a file cannot be written.
void TrainingRun::runTurns() {
  shareEnding();
  while (!training_->isDone() && !is_interrupted_ && !has_failed_) {
    const std::uint64_t before = training_->episode();
    const std::vector<LearnedEpisode> episodes = training_->runNextTurn();
    if (isFirstRank()) noteProblemOf([&] { deliver(before, episodes); });
    shareEnding();
  }
}

/// Writes and shows what was learned in a turn. Without checkpoints the training can go on, so that their first error
/// is only printed. @throws FileError if another file cannot be written
void TrainingRun::deliver(std::uint64_t before, const std::vector<LearnedEpisode>& episodes) {
  const std::uint64_t save_every = training_->config().training.save_every;
  files_->append(before, episodes);
  for (const LearnedEpisode& episode : episodes) display_->add(episode);
  if (save_every > 0 && training_->episode() / save_every > before / save_every) {
    saveQTable(nameAfter(arguments_.output, training_->episode()), training_->trained());
  }
  try {
    files_->saveCheckpointIfDue(*training_);
  } catch (const FileError& error) {
    if (!has_warned_) std::cerr << "\ntrain: " << error.what() << "; the training goes on" << std::endl;
    has_warned_ = true;
  }
  display_->show();
}

/// All ranks end if one of them is interrupted, or if a file cannot be written.
void TrainingRun::shareEnding() {
  std::vector<std::uint64_t> endings = {isInterrupted() ? 1U : 0U, has_failed_ ? 1U : 0U};
  ranks_.sum(endings);
  is_interrupted_ = endings[0] > 0;
  has_failed_ = endings[1] > 0;
}

void TrainingRun::printSummary(bool was_done) {
  const TrainedTable trained = training_->trained();
  std::cout << arguments_.output << ": " << training_->episode() << " episodes, " << trained.decisions << " decisions, "
            << trained.table.visitedRows() << " of " << trained.table.rows() << " rows visited, took "
            << formatDuration(display_->seconds())
            << (has_failed_       ? "; ended by an error"
                : was_done        ? "; was complete"
                : is_interrupted_ ? "; interrupted"
                                  : "")
            << std::endl;
}

/// Whether rank 0 can plot. Says why not.
bool canPlot(Communicator& ranks, const TrainingArguments& arguments) {
  std::vector<std::uint64_t> problems = {0};
  if (ranks.rank() == 0 && arguments.plot && !isTerminal()) {
    std::cerr << "train: --plot: standard error is no terminal; for a plot of a training in the background, write a "
                 "--log and draw it with plot_learning"
              << (ranks.size() > 1 ? "; for one under mpirun, see docs/mpi.md" : "")
              << "\nRun with --help for more information." << std::endl;
    problems.front() = 1;
  }
  ranks.sum(problems);
  return problems.front() == 0;
}

}  // namespace

int train(Communicator& ranks, const TrainingArguments& arguments) {
  if (!canPlot(ranks, arguments)) return EXIT_BAD_USAGE;
  // A pipe that nobody reads any more is an error in writing that file; it does not end the training.
  std::signal(SIGPIPE, SIG_IGN);
  TrainingRun run(ranks, arguments);
  run.begin();
  return run.run();
}

}  // namespace crowd
