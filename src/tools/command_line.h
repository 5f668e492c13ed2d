#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "training/communicator.h"

namespace crowd {

/// @brief Exit statuses of the tools.
enum ExitStatus : int { EXIT_FINE = 0, EXIT_BAD_INPUT = 1, EXIT_BAD_USAGE = 2, EXIT_INTERRUPTED = 130 };

/// @brief Parses the command line and runs the tool, alone or on the ranks that mpirun started. Prints help, version,
/// usage errors, and other errors (one line, "NAME: message"): on several ranks, those that all ranks know of are
/// printed once, by rank 0; one that only one rank knows of ends all.
/// @return the exit status.
int runTool(CLI::App& app, int argc, char** argv, const std::function<int(Communicator& ranks)>& run);

/// @brief Prints warnings of what was read on standard error, "TOOL: warning: ..." each.
void printReadingWarnings(const std::string& tool, const std::vector<std::string>& warnings);

/// @brief Returns a validator for whole numbers of at least `low`.
CLI::Validator atLeast(std::uint64_t low);

/// @brief Installs handlers for SIGINT and SIGTERM: the first signal sets isInterrupted(), the second one terminates
/// the process.
void catchInterrupts();
/// @brief Returns whether a signal was received.
bool isInterrupted();

}  // namespace crowd
