#include "web_server.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "scenario/reading/scenario_files.h"
#include "social_crowd/errors.h"

namespace crowd {

void showInBrowser(const std::string& scenario, const std::string& q_table, std::uint64_t seed, unsigned threads,
                   unsigned port) {
  namespace fs = std::filesystem;
  const fs::path package = fs::path(shippedScenarios()).parent_path().parent_path();  // share/social_crowd, or sources
  fs::path program = package.parent_path().parent_path() / "lib" / "social_crowd" / "web_server";
  std::error_code ignored;
  if (!fs::exists(program, ignored)) program = package / "scripts" / "web_server";
  const std::string seed_text = std::to_string(seed);
  const std::string threads_text = std::to_string(threads);
  const std::string port_text = std::to_string(port);
  execl(program.c_str(), program.c_str(), "--q-table", q_table.c_str(), "--seed", seed_text.c_str(), "--threads",
        threads_text.c_str(), "--port", port_text.c_str(), "--", scenario.c_str(), nullptr);
  throw FileError(program.string() + ": cannot be started: " + std::strerror(errno));
}

}  // namespace crowd
