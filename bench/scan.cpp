// A laser scan among people on the map of the benchmarks.

#include <benchmark/benchmark.h>

#include <vector>

#include "measuring.h"
#include "office.h"
#include "robots/scanner.h"

namespace crowd {
namespace {

constexpr std::size_t PEOPLE = 1000;
constexpr std::size_t SENSORS = 100;  // at the places of further people, who are not there

void scanPeople(benchmark::State& state) {
  const Scene scene = makeMapCrowd(benchmarkMap(), PEOPLE + SENSORS);
  const WallIndex walls(scene.walls);
  std::vector<ScanTarget> targets;
  for (BodyNumber i = 0; i < PEOPLE; ++i) targets.push_back({scene.agents[i].position, scene.agents[i].radius, i});
  Scanner scanner{ScanSpec()};
  std::vector<float> ranges;
  const KeyedRandom key(1, KeyedRandom::SENSOR, {0});
  const auto scan_from = [&](const AgentStart& place) {
    const Scan& scan =
        scanner.scan({place.position, place.heading}, {targets.data(), targets.size()}, {nullptr, 0}, walls);
    writeRanges(scan, scanner.spec(), key, ranges);
    benchmark::DoNotOptimize(ranges.data());
  };
  scan_from(scene.agents.front());  // allocates
  for (auto _ : state) {
    const double time = timeOf(Clock::OF_THREAD, [&] {
      for (std::size_t i = 0; i < SENSORS; ++i) scan_from(scene.agents[PEOPLE + i]);
    });
    state.SetIterationTime(time / SENSORS);
  }
}

}  // namespace

BENCHMARK(scanPeople)->Name("scan_720_1000")->Iterations(20)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace crowd
