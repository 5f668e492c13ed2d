#include "command_line.h"

#include <algorithm>
#include <charconv>
#include <csignal>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <vector>

#include "common/error_message.h"
#include "common/files/checksum.h"
#include "common/files/files.h"
#include "common/text/suggestions.h"
#include "ranks/mpi_communicator.h"
#include "social_crowd/errors.h"
#include "version.h"

namespace crowd {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void noteInterrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

/// The long options of a tool, with leading dashes.
std::vector<std::string> optionsOf(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

/// The error message for unknown arguments.
std::string unknownArguments(const CLI::App& app) {
  const std::vector<std::string> unknown = app.remaining();
  const auto is_option = [](const std::string& word) { return word.rfind("--", 0) == 0; };
  const auto found = std::find_if(unknown.begin(), unknown.end(), is_option);
  if (found == unknown.end()) return "unexpected argument: " + joinNames(unknown);
  const std::string name = found->substr(0, found->find('='));
  return "there is no option '" + name + "'" + didYouMean(name, optionsOf(app));
}

/// What to print in place of running the tool.
struct Answer {
  bool is_error = false;
  std::string text;
};

/// Returns the help text or the error in the command line.
Answer explainUsage(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    std::ostringstream help;
    app.exit(error, help, help);
    return {false, help.str()};
  }
  const bool is_extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  return {true, app.get_name() + ": " + (is_extra ? unknownArguments(app) : error.what()) +
                    "\nRun with --help for more information.\n"};
}

/// Parses the command line. Returns what to print, if the tool is not to run.
std::optional<Answer> parse(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return explainUsage(app, error);
  }
}

/// Returns the answer of the first rank that has one.
std::optional<Answer> ofFirstRank(Communicator& ranks, const std::optional<Answer>& own) {
  Communicator::Bytes bytes;
  if (own) {
    const std::string text = (own->is_error ? "E" : "H") + own->text;
    bytes.assign(text.begin(), text.end());
  }
  const std::vector<Communicator::Bytes> answers = ranks.gatherAll(bytes);
  const auto first =
      std::find_if(answers.begin(), answers.end(), [](const Communicator::Bytes& answer) { return !answer.empty(); });
  if (first == answers.end()) return std::nullopt;
  return Answer{first->front() == 'E', std::string(first->begin() + 1, first->end())};
}

int print(const Answer& answer) {
  (answer.is_error ? std::cerr : std::cout) << answer.text << std::flush;
  return answer.is_error ? EXIT_BAD_USAGE : EXIT_FINE;
}

std::string checksumOfProgram() {
  Checksum checksum;
  checksum.add(readFile("/proc/self/exe"));
  return checksum.text();
}

/// Runs the tool on several ranks.
int runOnRanks(const CLI::App& app, const std::optional<Answer>& own, Communicator& ranks,
               const std::function<int(Communicator&)>& run) {
  int status = EXIT_BAD_INPUT;
  try {
    // First of all: other programs exchange other messages.
    requireSameOnAllRanks(ranks, {{"program", app.get_name() + ", checksum " + checksumOfProgram()}});
    const std::optional<Answer> answer = ofFirstRank(ranks, own);
    if (!answer) {
      status = run(ranks);
    } else if (ranks.rank() == 0) {
      status = print(*answer);
    } else {
      status = answer->is_error ? EXIT_BAD_USAGE : EXIT_FINE;
    }
  } catch (const SharedError& error) {
    if (ranks.rank() == 0) std::cerr << app.get_name() << ": " << error.what() << std::endl;
  } catch (const std::exception& error) {
    ranks.abort(app.get_name() + ": rank " + std::to_string(ranks.rank()) + ": " + messageOf(error));
  }
  ranks.gatherAll({});  // mpirun ends all when the first one ends with another status than 0
  return status;
}

}  // namespace

CLI::Validator atLeast(std::uint64_t low) {
  const auto check = [low](const std::string& text) {
    std::uint64_t value = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool fine = read.ec == std::errc() && read.ptr == text.data() + text.size() && value >= low;
    return fine ? std::string() : "expected a whole number, " + std::to_string(low) + " or more, got '" + text + "'";
  };
  return CLI::Validator(check, std::to_string(low) + " or more", "at_least");
}

void catchInterrupts() {
  std::signal(SIGINT, noteInterrupt);
  std::signal(SIGTERM, noteInterrupt);
}

bool isInterrupted() { return interrupted != 0; }

int runTool(CLI::App& app, int argc, char** argv, const std::function<int(Communicator& ranks)>& run) {
  app.set_version_flag("--version", versionText(), "print version, digest of the sources, and compiler");
  try {
    const std::unique_ptr<Communicator> ranks = joinRanks();
    const std::optional<Answer> answer = parse(app, argc, argv);
    if (ranks->size() > 1) return runOnRanks(app, answer, *ranks, run);
    return answer ? print(*answer) : run(*ranks);
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << messageOf(error) << std::endl;
    return EXIT_BAD_INPUT;
  }
}

void printReadingWarnings(const std::string& tool, const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) std::cerr << tool << ": warning: " << warning << "\n";
}

}  // namespace crowd
