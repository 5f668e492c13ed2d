#include "ros/node/node_main.h"

#include <algorithm>
#include <string>

namespace crowd {

bool printUsage(int argc, char** argv, const char* name, const NodeUsage& usage) {
  const bool is_wanted =
      std::any_of(argv + 1, argv + argc, [](const std::string& word) { return word == "-h" || word == "--help"; });
  if (!is_wanted) return false;
  std::cout
      << "usage: rosrun social_crowd " << name << " [_PARAMETER:=VALUE ...] [NAME:=OTHER_NAME ...]\n\n"
      << usage.what << "\n\nexample:\n  rosrun social_crowd " << name << ' ' << usage.example
      << "\n\nParameters, topics and services: docs/ros.md. Exit status: 0 success, also after Ctrl-C; 1 a parameter "
         "or a file is wrong.\n";
  return true;
}

}  // namespace crowd
