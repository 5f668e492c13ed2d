#include "command_line.h"

#include <charconv>
#include <csignal>
#include <iostream>

#include "social_crowd/common/errors.h"

namespace crowd {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void noteInterrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
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
    return app.exit(error) == 0 ? EXIT_FINE : EXIT_BAD_USAGE;
  }
  try {
    return run();
  } catch (const std::exception& error) {
    std::cerr << app.get_name() << ": " << error.what() << std::endl;
    return EXIT_BAD_INPUT;
  }
}

}  // namespace crowd
