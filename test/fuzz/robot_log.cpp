// Logs of robots, which are read and scored.

#include "robots/log/robot_log_scoring.h"

#include "fuzz/fuzz.h"
#include "support/temporary_folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace crowd;
  static const TemporaryFolder folder;
  const std::string name = folder.write("input", fuzz::textOf(data, size));
  LogScoring scoring;
  scoring.on_episode = [](const RobotLogReplay& replay) { replay.results(); };
  return fuzz::feed(size, 1000, [&] { scoreRobotLog(name, {}, scoring); });
}
