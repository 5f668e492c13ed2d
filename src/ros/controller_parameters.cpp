#include "social_crowd/ros/controller_parameters.h"

#include "social_crowd/common/files.h"
#include "social_crowd/common/numbers.h"
#include "social_crowd/simulation/training_config.h"
#include "social_crowd/world/scenario_files.h"

namespace crowd {
namespace {

constexpr double MAX_REAL_TIME_FACTOR = 1e6;
constexpr double MAX_DEADLINE = 3600.0;  // [s]
constexpr double MAX_RATE = 1e6;         // [Hz]
constexpr std::int64_t MAX_WHOLE = INT32_MAX;
constexpr const char* FAST = "fast";

bool isRealTimeFactor(double factor) { return factor >= 0.0 && factor <= MAX_REAL_TIME_FACTOR; }

double readRealTimeFactor(Parameters& parameters, double otherwise) {
  const std::string text = parameters.text("real_time_factor", toText(otherwise));
  if (text == FAST) return 0.0;
  const std::optional<double> factor = toNumber(text);
  if (factor && isRealTimeFactor(*factor)) return *factor;
  parameters.complain("real_time_factor",
                      "expected 'fast' or a factor of real time from 0 (fast) to 1e6, got '" + text + "'");
  return otherwise;
}

/// Takes scenarios, episodes and seed from a training configuration.
void useConfig(Parameters& parameters, ControllerParameters& read) {
  const std::string file = parameters.text("config", "");
  if (file.empty()) return;
  try {
    const TrainingConfig config = readTrainingConfig(file);
    read.scenarios = config.training.scenarios;
    read.episodes = config.training.episodes;
    read.seed = config.training.seed;
    read.name = stemOf(file);
  } catch (const Error& error) {
    parameters.complain("config", error.what());
  }
}

void readScenario(Parameters& parameters, ControllerParameters& read) {
  read.scenario_folder = parameters.text("scenario_folder", shippedScenarios());
  const std::string scenario = parameters.text("scenario", "");
  if (scenario.empty()) {
    if (parameters.isSet("scenario") || parameters.isSet("config")) return;
    return parameters.complainMissing("scenario", "expected a scenario file or name, or ~config, got nothing");
  }
  try {
    read.scenarios = {findScenario(scenario, "", read.scenario_folder)};
    read.name = stemOf(read.scenarios.front());
  } catch (const InputError& error) {
    parameters.complain("scenario", error.what());
  }
}

void readRobots(Parameters& parameters, ControllerParameters& read) {
  read.robot_lockstep = parameters.flag("robot_lockstep", read.robot_lockstep);
  read.command_deadline = parameters.number("command_deadline", read.command_deadline, 1e-3, MAX_DEADLINE);
  read.command_period = parameters.number("command_period", read.command_period, 0.0, MAX_DEADLINE);
  read.publish_localisation = parameters.flag("publish_localisation", read.publish_localisation);
  read.visible_people_only = parameters.flag("visible_people_only", read.visible_people_only);
  if (read.robot_lockstep && !read.publish_clock) {
    parameters.complain("robot_lockstep", "needs ~publish_clock: true");
  }
}

}  // namespace

void requireRealTimeFactor(double factor) {
  if (isRealTimeFactor(factor)) return;
  throw InputError("factor: expected a factor of real time from 0 (as fast as possible) to 1e6, got " + toText(factor));
}

std::string realTimeFactorText(double factor) { return factor > 0.0 ? toText(factor) : FAST; }

ControllerParameters readControllerParameters(const ros::NodeHandle& private_node) {
  Parameters parameters(private_node);
  ControllerParameters read;
  useConfig(parameters, read);
  readScenario(parameters, read);
  read.map_topic = parameters.text("map_topic", "");
  read.seed = static_cast<std::uint64_t>(parameters.whole("seed", static_cast<std::int64_t>(read.seed), 0, MAX_WHOLE));
  read.episodes =
      static_cast<std::uint64_t>(parameters.whole("episodes", static_cast<std::int64_t>(read.episodes), 0, MAX_WHOLE));
  read.real_time_factor = readRealTimeFactor(parameters, read.real_time_factor);
  read.paused = parameters.flag("paused", read.paused);
  read.start_deadline = parameters.number("start_deadline", read.start_deadline, 0.0, MAX_DEADLINE);
  read.answer_deadline = parameters.number("answer_deadline", read.answer_deadline, 1e-3, MAX_DEADLINE);
  read.misses_until_absent =
      static_cast<int>(parameters.whole("misses_until_absent", read.misses_until_absent, 1, MAX_WHOLE));
  read.agents_rate = parameters.number("agents_rate", read.agents_rate, 0.0, MAX_RATE);
  read.publish_tf = parameters.flag("publish_tf", read.publish_tf);
  read.publish_clock = parameters.flag("publish_clock", read.publish_clock);
  readRobots(parameters, read);
  read.trajectories = parameters.text("trajectories", "");
  read.ends_launch = parameters.flag("ends_launch", read.ends_launch);
  parameters.finish();
  return read;
}

}  // namespace crowd
