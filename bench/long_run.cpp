// Days in which people enter and leave: a station hall with some 100,000 of them (bench/scenarios/station_day.yaml),
// and a hall with 200 at a time, who learn (bench/scenarios/learning_day.yaml).

#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "learning/q_table_file.h"
#include "measuring.h"
#include "scenario/reading/scenario_reader.h"
#include "simulation/crowd_decider.h"
#include "simulation/episode.h"
#include "simulation/evaluation/evaluation.h"

namespace crowd {
namespace {

constexpr int HOURS = 24;
constexpr double HOUR = 3600.0;  // [s]

/// Resident memory of the process [MB of 10^6 bytes].
double residentMegabytes() {
  std::ifstream status("/proc/self/status");
  std::string key;
  while (status >> key && key != "VmRSS:") std::getline(status, key);
  double kibibytes = 0.0;
  status >> kibibytes;
  return kibibytes * 1024.0 / 1e6;
}

/// Number of open descriptors of the process.
std::size_t openDescriptors() {
  const std::filesystem::directory_iterator open("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(open), end(open)));
}

/// What was measured in an hour.
struct Hour {
  std::size_t agent_steps = 0;
  double seconds = 0.0;    // of processor time
  double megabytes = 0.0;  // at its end
  std::size_t descriptors = 0;
  double rate() const { return static_cast<double>(agent_steps) / seconds; }
};

/// The hour after the first one, which warms up, and the last one.
struct Day {
  Hour early;
  Hour late;
};

/// A scenario, a Q-table, and whether it learns.
struct Crowd {
  std::string scenario;
  std::string table;
  Mode mode = Mode::DEMO;
};

const Crowd STATION{"station_day", "human", Mode::DEMO};
const Crowd LEARNING_HALL{"learning_day", "anticipation", Mode::TRAINING};

Day walkADay(const Crowd& crowd) {
  const std::string folder = SOURCE_DIR;
  const ScenarioList scenarios = readScenarios(folder + "/bench/scenarios/" + crowd.scenario + ".yaml");
  Learner learner = makeDemoLearner(loadQTable(folder + "/config/q_tables/" + crowd.table + ".txt"), 1);
  learner.setMode(crowd.mode);
  Episode episode(scenarios.scene(1, 0), 0, learner.model().vision());
  CrowdDecider decider(learner);
  Day day;
  for (int number = 0; number < HOURS; ++number) {
    Hour hour;
    hour.seconds = timeOf(Clock::OF_THREAD, [&] {
      while (episode.world().time() < (number + 1) * HOUR && !episode.isOver()) {
        hour.agent_steps += episode.world().activeCount();
        episode.walk(decider);
      }
    });
    hour.megabytes = residentMegabytes();
    hour.descriptors = openDescriptors();
    if (number == 1) day.early = hour;
    day.late = hour;
  }
  return day;
}

void compareRates(benchmark::State& state, const Crowd& crowd) {
  for (auto _ : state) {
    const Day day = walkADay(crowd);
    state.SetIterationTime(day.late.seconds);
    setRate(state, day.late.agent_steps);
    state.counters["yardstick_rate"] = day.early.rate();
  }
}

void compareMemory(benchmark::State& state, const Crowd& crowd) {
  for (auto _ : state) {
    const Day day = walkADay(crowd);
    state.SetIterationTime(day.late.seconds);
    state.counters["megabytes"] = day.late.megabytes;
    state.counters["yardstick_rate"] = day.early.megabytes;
    if (day.late.descriptors != day.early.descriptors) state.SkipWithError("the number of open descriptors changed");
  }
}

}  // namespace

BENCHMARK_CAPTURE(compareRates, station, STATION)
    ->Name("long_run")
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compareMemory, station, STATION)
    ->Name("long_run_memory")
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compareMemory, hall, LEARNING_HALL)
    ->Name("learning_day_memory")
    ->Iterations(1)
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace crowd
