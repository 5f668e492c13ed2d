// Memory of a large crowd. The result is valid only if nothing else has run in the same process.

#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

#include "crowd_walk.h"

namespace crowd {
namespace {

/// Peak resident memory of the process [MB of 10^6 bytes].
double peakResidentMegabytes() {
  std::ifstream status("/proc/self/status");
  std::string key;
  while (status >> key && key != "VmHWM:") std::getline(status, key);
  double kibibytes = 0.0;
  status >> kibibytes;
  return kibibytes * 1024.0 / 1e6;
}

void walkLargeCrowd(benchmark::State& state) {
  CrowdPlan plan;
  plan.agents = 100'000;
  CrowdWalk crowd(plan);
  for (auto _ : state) crowd.step();
  state.counters["megabytes"] = peakResidentMegabytes();
}

}  // namespace

BENCHMARK(walkLargeCrowd)->Name("memory_100000")->Iterations(5)->Unit(benchmark::kMillisecond);

}  // namespace crowd
