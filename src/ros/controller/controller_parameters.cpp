#include "ros/controller/controller_parameters.h"

#include "common/files/files.h"
#include "common/text/numbers.h"
#include "common/text/quotes.h"
#include "scenario/reading/scenario_files.h"
#include "training/training_config.h"

namespace crowd {
namespace {

constexpr const char* FAST = "fast";

double readRealTimeFactor(Parameters& parameters, double otherwise) {
  const std::string expected = "'fast' or " + toText(ControllerParameters::REAL_TIME_FACTOR);
  const std::string text = parameters.text("real_time_factor", toText(otherwise), expected);
  if (text == FAST) return 0.0;
  const std::optional<double> factor = toNumber(text);
  if (factor && ControllerParameters::REAL_TIME_FACTOR.contains(*factor)) return *factor;
  parameters.complain("real_time_factor", "expected " + expected + ", got " + inQuotes(text));
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
  read.command_deadline = parameters.number("command_deadline", read.command_deadline, ControllerParameters::DEADLINE);
  read.command_period = parameters.number("command_period", read.command_period, ControllerParameters::COMMAND_PERIOD);
  read.publish_localisation = parameters.flag("publish_localisation", read.publish_localisation);
  read.odometry_rate = parameters.number("odometry_rate", read.odometry_rate, ControllerParameters::ODOMETRY_RATE);
  read.visible_people_only = parameters.flag("visible_people_only", read.visible_people_only);
  using Metrics = RobotMetricOptions;
  Metrics& metrics = read.robot_metrics;
  metrics.progress_distance =
      parameters.number("progress_distance", metrics.progress_distance, Metrics::PROGRESS_DISTANCE);
  metrics.progress_time = parameters.number("progress_time", metrics.progress_time, Metrics::PROGRESS_TIME);
  metrics.stalled_speed = parameters.number("stalled_speed", metrics.stalled_speed, Metrics::STALLED_SPEED);
  if (read.robot_lockstep && !read.publish_clock) {
    parameters.complain("robot_lockstep", "needs ~publish_clock: true");
  }
}

void readRecordings(Parameters& parameters, ControllerParameters& read) {
  read.trajectories = parameters.text("trajectories", "");
  read.robot_series = parameters.text("robot_series", "");
  read.robot_logs = parameters.text("robot_logs", "");
  if (!read.robot_series.empty() && fullPath(read.robot_series) == fullPath(read.trajectories)) {
    const std::string expected = "expected another folder than that of ~trajectories, got ";
    parameters.complain("robot_series", expected + inQuotes(read.robot_series));
  }
}

}  // namespace

std::string realTimeFactorText(double factor) { return factor > 0.0 ? toText(factor) : FAST; }

ControllerParameters readControllerParameters(const ros::NodeHandle& private_node) {
  Parameters parameters(private_node);
  ControllerParameters read;
  useConfig(parameters, read);
  readScenario(parameters, read);
  read.data_folder = readDataFolder(parameters);
  read.map_topic = parameters.text("map_topic", "");
  read.seed = static_cast<std::uint64_t>(parameters.whole("seed", static_cast<std::int64_t>(read.seed), 0, MAX_WHOLE));
  read.episodes =
      static_cast<std::uint64_t>(parameters.whole("episodes", static_cast<std::int64_t>(read.episodes), 0, MAX_WHOLE));
  read.real_time_factor = readRealTimeFactor(parameters, read.real_time_factor);
  read.paused = parameters.flag("paused", read.paused);
  read.start_deadline = parameters.number("start_deadline", read.start_deadline, ControllerParameters::START_DEADLINE);
  read.answer_deadline = parameters.number("answer_deadline", read.answer_deadline, ControllerParameters::DEADLINE);
  const NumberRange& misses = ControllerParameters::MISSES;
  read.misses_until_absent =
      static_cast<int>(parameters.whole("misses_until_absent", read.misses_until_absent,
                                        static_cast<std::int64_t>(misses.low), static_cast<std::int64_t>(misses.high)));
  read.threads = readThreads(parameters);
  read.agents_rate = parameters.number("agents_rate", read.agents_rate, ControllerParameters::AGENTS_RATE);
  read.diagnostic_period = readDiagnosticPeriod(parameters);
  read.publish_tf = parameters.flag("publish_tf", read.publish_tf);
  read.publish_clock = parameters.flag("publish_clock", read.publish_clock);
  readRobots(parameters, read);
  readRecordings(parameters, read);
  read.ends_launch = parameters.flag("ends_launch", read.ends_launch);
  parameters.finish();
  return read;
}

LiveParameters<ControllerParameters> liveControllerParameters() {
  using P = ControllerParameters;
  LiveParameters<P> live;
  live.add({"real_time_factor", "factor of real time; 0: as fast as possible", P::REAL_TIME_FACTOR, {}},
           &P::real_time_factor);
  live.add({"paused", "pause before the next tick", {}, {}}, &P::paused);
  live.add({"start_deadline", "timeout for learners that have never answered [s]", P::START_DEADLINE, {}},
           &P::start_deadline);
  live.add({"answer_deadline", "timeout for an answer [s]", P::DEADLINE, {}}, &P::answer_deadline);
  live.add({"misses_until_absent",
            "consecutive missed answers until an agent, or commands until a robot, is absent",
            P::MISSES,
            {}},
           &P::misses_until_absent);
  live.add({"command_deadline", "timeout for the commands of robots [s]", P::DEADLINE, {}}, &P::command_deadline);
  live.add({"agents_rate", "maximum rate of the topic agents and of tf [Hz]; 0: every tick", P::AGENTS_RATE, {}},
           &P::agents_rate);
  return live;
}

}  // namespace crowd
