#include "ros/node/launch_end.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace crowd {
namespace {

/// Returns program and arguments of a process; empty if they cannot be read.
std::vector<std::string> commandOf(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/cmdline");
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

/// Whether a command is roslaunch, run directly or by an interpreter. A roslaunch with -c is the child of one on
/// another machine, which would report its end as an error.
bool isRoslaunch(const std::vector<std::string>& command) {
  const auto program_end = command.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(command.size(), 2));
  const bool found = std::any_of(command.begin(), program_end, [](const std::string& word) {
    return std::filesystem::path(word).filename() == "roslaunch";
  });
  return found && std::find(program_end, command.end(), "-c") == command.end();
}

}  // namespace

bool endLaunch() {
  const pid_t parent = ::getppid();
  return isRoslaunch(commandOf(parent)) && ::kill(parent, SIGINT) == 0;
}

}  // namespace crowd
