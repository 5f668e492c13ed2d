#include "command_line.h"

#include <algorithm>
#include <charconv>
#include <csignal>
#include <iostream>

#include "social_crowd/common/errors.h"
#include "social_crowd/common/suggestions.h"

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

/// Prints the help text or the error in the command line. Returns the exit status.
int explainUsage(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  const bool is_extra = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
  std::cerr << app.get_name() << ": " << (is_extra ? unknownArguments(app) : error.what())
            << "\nRun with --help for more information." << std::endl;
  return EXIT_BAD_USAGE;
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

int runTool(CLI::App& app, int argc, char** argv, const std::function<int()>& run) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return explainUsage(app, error);
  }
  try {
    return run();
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << std::endl;
    return EXIT_BAD_INPUT;
  }
}

}  // namespace crowd
