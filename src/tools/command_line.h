#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

namespace crowd {

/// @brief Exit statuses of the tools.
enum ExitStatus : int { EXIT_FINE = 0, EXIT_BAD_INPUT = 1, EXIT_BAD_USAGE = 2, EXIT_INTERRUPTED = 130 };

/// @brief Parses the command line and runs the tool. Prints help, wrong usage, and errors (one line, "NAME: what").
/// @return the exit status.
int runTool(CLI::App& app, int argc, char** argv, const std::function<int()>& run);

/// @brief Checks that an option is a whole number of at least `low`.
CLI::Validator atLeast(std::uint64_t low);

/// @brief From now on the first Ctrl-C asks the tool to come to an end by itself, the second one kills it.
void catchInterrupts();
/// @brief Whether the user asked to stop.
bool isInterrupted();

}  // namespace crowd
