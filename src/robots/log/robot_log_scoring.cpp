#include "robots/log/robot_log_scoring.h"

#include <optional>

#include "robots/log/robot_log_reading.h"
#include "social_crowd/errors.h"

namespace crowd {

void scoreRobotLog(const std::string& file, const RobotMetricOptions& options, const LogScoring& scoring,
                   FileKinds kinds) {
  std::optional<RobotLogReplay> replay;
  const auto finish = [&] {
    if (!replay) return;
    if (!replay->hasBegun()) throw InputError(file + ": expected ticks behind each header, got a header without any");
    if (scoring.on_episode) scoring.on_episode(*replay);
  };
  const auto begin = [&](const RobotLogHeader& header) {
    finish();
    replay.emplace(header, options);
  };
  const auto add = [&](const RobotLogTick& tick) {
    try {
      replay->add(tick);
    } catch (const InputError& error) {
      throw InputError(file + ": line " + std::to_string(tick.line) + ": " + error.what());
    }
    if (scoring.on_tick) scoring.on_tick(*replay);
  };
  readRobotLog(file, begin, add, kinds);
  if (!replay) throw InputError(file + ": expected a log of robots, got no header with the key 'tick_duration'");
  finish();
}

}  // namespace crowd
