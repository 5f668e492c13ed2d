// A day in a station hall (bench/scenarios/station_day.yaml), in which some 100,000 people enter and leave.

#include <benchmark/benchmark.h>

#include <fstream>
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

/// What was measured in an hour.
struct Hour {
  std::size_t agent_steps = 0;
  double seconds = 0.0;    // of processor time
  double megabytes = 0.0;  // at its end
  double rate() const { return static_cast<double>(agent_steps) / seconds; }
};

/// The hour after the first one, which warms up, and the last one.
struct Day {
  Hour early;
  Hour late;
};

Day walkADay() {
  const std::string folder = SOURCE_DIR;
  const ScenarioList scenarios = readScenarios(folder + "/bench/scenarios/station_day.yaml");
  Learner learner = makeDemoLearner(loadQTable(folder + "/config/q_tables/human.txt"), 1);
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
    if (number == 1) day.early = hour;
    day.late = hour;
  }
  return day;
}

void compareRates(benchmark::State& state) {
  for (auto _ : state) {
    const Day day = walkADay();
    state.SetIterationTime(day.late.seconds);
    setRate(state, day.late.agent_steps);
    state.counters["yardstick_rate"] = day.early.rate();
  }
}

void compareMemory(benchmark::State& state) {
  for (auto _ : state) {
    const Day day = walkADay();
    state.SetIterationTime(day.late.seconds);
    state.counters["megabytes"] = day.late.megabytes;
    state.counters["yardstick_rate"] = day.early.megabytes;
  }
}

}  // namespace

BENCHMARK(compareRates)->Name("long_run")->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK(compareMemory)->Name("long_run_memory")->Iterations(1)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace crowd
